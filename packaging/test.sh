#!/usr/bin/env bash
# Installs what is missing, then builds and tests everything, and stops at the first stage that fails. Under an
# hour on two cores.
#   KICKSTAND_TIDY=0   without the clang-tidy stage
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

logs=build/test-logs
summary=()

# stage NAME COMMAND... : runs the command, keeps its output in a file too, and remembers how long it took.
stage() {
    local name="$1" log began="$SECONDS"
    shift
    log="$logs/${name// /-}.log"
    say "$name: $*"
    "$@" 2>&1 | tee "$log" || die "stage \"$name\" failed after $((SECONDS - began)) s; its output is above and in $log"
    summary+=("$(printf '%5d s  %s' $((SECONDS - began)) "$name")")
    # ctest's own totals belong to the summary, in its own words.
    local line
    while read -r line; do
        summary+=("           $line")
    done < <(grep -E '^([0-9]+% tests passed|Total Test time)' "$log")
}

# preset NAME [LAUNCHER...] : configures, builds and tests one of CMakePresets.json, the tests under the launcher.
preset() {
    local name="$1"
    shift
    stage "$name configure" cmake --preset "$name"
    stage "$name build" cmake --build --preset "$name" --parallel "$(nproc)"
    stage "$name tests" "$@" ctest --preset "$name" --parallel "$(nproc)"
}

install_packages packaging/packages-run.txt packaging/packages-test.txt
mkdir -p "$logs"
use_ccache

stage "format" packaging/lint.sh --format-only
preset dev
if [ "${KICKSTAND_TIDY:-1}" = 1 ]; then
    stage "clang-tidy" packaging/lint.sh --tidy-only core
else
    summary+=("       -    clang-tidy: left out (KICKSTAND_TIDY=${KICKSTAND_TIDY:-1})")
fi

# Kernels that scatter addresses widely leave the sanitizers of g++ 12 no room for their shadow memory.
fixed_addresses=()
if setarch -R true 2>/dev/null; then
    fixed_addresses=(setarch -R)
fi
preset asan "${fixed_addresses[@]}"
preset tsan "${fixed_addresses[@]}"

say "Every stage passed"
printf '%s\n' "${summary[@]}"
