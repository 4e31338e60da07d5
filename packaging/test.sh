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

# build NAME : configures and builds one of CMakePresets.json.
build() {
    stage "$1 configure" cmake --preset "$1"
    stage "$1 build" cmake --build --preset "$1" --parallel "$(nproc)"
}

# tests NAME ARGUMENT... : runs tests of a preset.
tests() {
    local name="$1"
    shift
    stage "$name tests" "${fixed_addresses[@]}" ctest --preset "$name" --parallel "$(nproc)" "$@"
}

# Tests of windows and programs mostly wait: clang-tidy takes what they leave of the processors.
tidy=""
begin_tidy() {
    say "clang-tidy: begins beside the tests"
    setsid nice -n 19 packaging/lint.sh --tidy-only core >"$logs/clang-tidy.log" 2>&1 &
    tidy=$!
    trap 'kill -- "-$tidy" 2>/dev/null || true' EXIT
}

end_tidy() {
    local began="$SECONDS"
    say "clang-tidy: waiting for the rest of it"
    wait "$tidy" || {
        cat "$logs/clang-tidy.log"
        die "clang-tidy failed; its output is above and in $logs/clang-tidy.log"
    }
    trap - EXIT
    summary+=("$(printf '%5d s  clang-tidy, beyond the dev tests' $((SECONDS - began)))")
}

install_packages packaging/packages-run.txt packaging/packages-test.txt
mkdir -p "$logs"
use_ccache

# Kernels that scatter addresses widely leave the sanitizers of g++ 12 no room for their shadow memory.
fixed_addresses=()
if setarch -R true 2>/dev/null; then
    fixed_addresses=(setarch -R)
fi

stage "format" packaging/lint.sh --format-only
build dev
[ "${KICKSTAND_TIDY:-1}" = 0 ] || begin_tidy
tests dev --label-exclude 'ui|program'
# Windows and programs run by the machine's own clock. One that fails is tried once more, and the log shows both.
stage "dev tests of windows and programs" ctest --preset dev --label-regex 'ui|program' --repeat until-pass:2
if [ -n "$tidy" ]; then
    end_tidy
else
    summary+=("       -    clang-tidy: left out (KICKSTAND_TIDY=$KICKSTAND_TIDY)")
fi

for sanitizer in asan tsan; do
    build "$sanitizer"
    tests "$sanitizer"
done

say "Every stage passed"
printf '%s\n' "${summary[@]}"
