#!/usr/bin/env bash
# Runs every benchmark on a release build and prints all figures as one JSON object. Takes some two minutes; a machine
# that does something else meanwhile gives other figures.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

programs=(thunderbots/bench_engine thunderbots/bench_engine_usbip thunderbots/bench_decode thunderbots/bench_flash coach/bench_xbee smartdevice/bench_smartdevice telemetry/bench_telemetry
    ui/bench_start ui/bench_plot)
# Needs umockdev, without which there is no bus to emulate.
if pkg-config --exists umockdev-1.0 && command -v umockdev-wrapper >/dev/null; then
    programs+=(thunderbots/bench_engine_umockdev)
fi

build=build/release-bench
log=$build/build.log
mkdir -p "$build"
if ! { cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DKICKSTAND_TESTS=OFF -DKICKSTAND_BENCH=ON &&
    ninja -C "$build" "${programs[@]##*/}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "$0: the build failed; the whole log is $log" >&2
    exit 1
fi

# A window opens on the display there is, or on none.
[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}${QT_QPA_PLATFORM:-}" ] || export QT_QPA_PLATFORM=offscreen

separator='{'
for program in "${programs[@]}"; do
    launcher=()
    [ "${program##*_}" != umockdev ] || launcher=(env TMPDIR=/tmp umockdev-wrapper)
    figures=$("${launcher[@]}" "$build/tests/bench/$program")
    printf '%s"%s": %s' "$separator" "${program##*/bench_}" "$figures"
    separator=$',\n'
done
printf '}\n'
