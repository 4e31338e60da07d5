#!/usr/bin/env bash
# Runs one soak in full, on a release build, and prints its figures as JSON:
#   run.sh thunderbots-day [HOURS] [SEED]
#   run.sh unplug [loopback|usbip] [MOMENTS] [SEED]
#   run.sh window [MINUTES]    the window in real time, an hour by default; offscreen where there is no display
#   run.sh usb-guest      a real Linux USB stack in qemu; prints a line a check

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
    echo "usage: $0 thunderbots-day [HOURS] [SEED] | unplug [loopback|usbip] [MOMENTS] [SEED] | window [MINUTES] | usb-guest" >&2
    exit 2
}

[ $# -ge 1 ] || usage
case "$1" in
thunderbots-day) program=thunderbots_day ;;
unplug) program=unplug ;;
window) program=window ;;
usb-guest) exec tests/soak/usb-guest/run.sh ;;
*) usage ;;
esac
shift

build=build/release-core
gui=OFF
if [ "$program" = window ]; then
    build=build/release
    gui=ON
    [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || export QT_QPA_PLATFORM=offscreen
fi
log=$build/build.log
mkdir -p "$build"
if ! { cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DKICKSTAND_GUI=$gui -DKICKSTAND_BENCH=ON &&
    ninja -C "$build" "$program"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "$0: the build failed; the whole log is $log" >&2
    exit 1
fi
exec "$build/tests/soak/$program" "$@"
