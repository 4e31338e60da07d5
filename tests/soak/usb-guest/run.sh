#!/usr/bin/env bash
# The simulated dongle on a real Linux USB stack: serves it over USB/IP, boots Debian's kernel in qemu (emulated, so no
# rights are needed), attaches it there, and has kickstandctl use it through libusb as any dongle; then compares what the
# simulated robots received with what was asked for. Prints a line a check; exit code 0 when all held. Some two minutes,
# and a download of 75 MB the first time.   tests/soak/run.sh usb-guest
#   KICKSTAND_CACHE=FOLDER   where the guest's kernel is kept (default: ~/.cache/kickstand)
#   KEEP=1                   keeps the guest's logs, and says where
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
cache=${KICKSTAND_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/kickstand}/usb-guest

die() {
    echo "usb-guest: $*" >&2
    exit 1
}
command -v qemu-system-x86_64 >/dev/null || die "there is no qemu: apt-get install --no-install-recommends qemu-system-x86"
[ -e "$cache/prepared" ] || bash "$here/prepare.sh" "$cache"

build=$root/build/release-guest
mkdir -p "$build"
if ! { cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DKICKSTAND_TESTS=OFF -DKICKSTAND_BENCH=OFF &&
    ninja -C "$build" kickstandctl kickstand-sim; } >"$build/build.log" 2>&1; then
    tail -n 20 "$build/build.log" >&2
    die "the build failed; the whole log is $build/build.log"
fi

run=$(mktemp -d)
mkdir "$run/exchange"
simulator=
guest=
finish() {
    [ -z "$guest" ] || kill "$guest" 2>/dev/null || true
    [ -z "$simulator" ] || kill "$simulator" 2>/dev/null || true
    wait 2>/dev/null || true
    if [ "${KEEP:-0}" = 1 ]; then
        echo "usb-guest: the logs are in $run" >&2
    else
        rm -rf "$run"
    fi
}
trap finish EXIT

sim=$build/app/kickstand-sim
"$sim" thunderbots --usbip --port 0 --robots 0,3,5 --radio ideal --control "$run/control" >"$run/simulator.log" 2>&1 &
simulator=$!
for _ in $(seq 100); do
    port=$(sed -n 's/.*usbip:127\.0\.0\.1:\([0-9]*\).*/\1/p' "$run/simulator.log" | head -n 1)
    [ -z "$port" ] || break
    kill -0 "$simulator" 2>/dev/null || break
    sleep 0.1
done
[ -n "${port:-}" ] || {
    cat "$run/simulator.log" >&2
    die "the simulator did not begin"
}

cp "$here/guest.sh" "$run/exchange/"
cat >"$run/exchange/settings" <<E2
port=$port
tools='$cache/tools/sbin'
programs='$build/app'
exchange='$run/exchange'
rule='$root/packaging/udev/60-kickstand.rules'
E2

timeout "${TIMEOUT:-900}" qemu-system-x86_64 -machine q35,accel=tcg -cpu max -smp 2 -m 1024 -nodefaults -display none -no-reboot \
    -kernel "$cache/kernel" -initrd "$cache/initramfs" -append "console=ttyS0 quiet panic=-1 mitigations=off" \
    -netdev user,id=net -device virtio-net-pci,netdev=net,romfile= \
    -fsdev local,id=host,path=/,security_model=none,readonly=on,multidevs=remap -device virtio-9p-pci,fsdev=host,mount_tag=host \
    -fsdev local,id=exchange,path="$run/exchange",security_model=none -device virtio-9p-pci,fsdev=exchange,mount_tag=exchange \
    -serial file:"$run/console.log" -serial file:"$run/guest.log" </dev/null 2>"$run/qemu.log" &
guest=$!

# What the guest wants to know of the simulator, or done to it, it asks in files ask.N and reads in answer.N.
while kill -0 "$guest" 2>/dev/null; do
    for question in "$run"/exchange/ask.*; do
        [ -e "$question" ] || continue
        answer=$run/exchange/answer.${question##*.}
        mapfile -t words <"$question"
        rm "$question"
        "$sim" ctl --control "$run/control" "${words[@]}" >"$answer.part" 2>&1 || true
        mv "$answer.part" "$answer"
    done
    sleep 0.05
done
wait "$guest" || true
guest=

cat "$run/guest.log"
[ -e "$run/exchange/exit" ] || {
    tail -n 20 "$run/console.log" "$run/qemu.log" >&2
    die "the guest ended before its time"
}
code=$(cat "$run/exchange/exit")
[ "$code" = 0 ] || {
    sed 's/^/simulator: /' "$run/simulator.log"
    die "$(grep -c '^FAILED' "$run/guest.log") of the checks above did not hold"
}
echo "usb-guest: all $(grep -c '^ok' "$run/guest.log") checks held"
