#!/usr/bin/env bash
# Checks the sources' format, and what clang-tidy finds in them. Whoever includes whom is checked by ctest.
#   packaging/lint.sh                   format of everything, clang-tidy on app, core, ui and tests
#   packaging/lint.sh core/base ui      the same, of these files and folders
#   packaging/lint.sh --format-only     without clang-tidy
#   packaging/lint.sh --tidy-only PATH  without the format
#   packaging/lint.sh --fix             rewrites the files to the format first
# clang-tidy reads build/dev/compile_commands.json; KICKSTAND_BUILD names another build's folder.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

format=1 tidy=1 fix=0 paths=()
for argument in "$@"; do
    case "$argument" in
        --format-only) tidy=0 ;;
        --tidy-only) format=0 ;;
        --fix) fix=1 ;;
        -*) die "unknown option $argument; the head of this script lists what there is" ;;
        *)
            [ -e "$argument" ] || die "there is no $argument"
            paths+=("${argument%/}")
            ;;
    esac
done
[ "${#paths[@]}" -gt 0 ] || paths=(app core ui tests)

# The fixtures of the rule test are broken on purpose.
sources() {
    find "${paths[@]}" -path tests/data -prune -o -type f \( -name '*.cpp' -o -name '*.h' \) -print | sort
}

if [ "$format" = 1 ]; then
    command -v clang-format >/dev/null || die "clang-format is not installed: apt-get install clang-format"
    mapfile -t files < <(sources)
    say "Format of ${#files[@]} files"
    if [ "${#files[@]}" -gt 0 ]; then
        [ "$fix" = 0 ] || clang-format -i "${files[@]}"
        clang-format --dry-run --Werror "${files[@]}" ||
            die "the files above are not formatted; packaging/lint.sh --format-only --fix rewrites them"
    fi
fi

if [ "$tidy" = 1 ]; then
    build="${KICKSTAND_BUILD:-build/dev}"
    command -v run-clang-tidy >/dev/null || die "clang-tidy is not installed: apt-get install clang-tidy"
    [ -e "$build/compile_commands.json" ] || die "$build is not configured: cmake --preset dev"
    # run-clang-tidy takes regular expressions on full paths; sources that a build generates lie elsewhere.
    patterns=()
    for path in "${paths[@]}"; do
        if [ -d "$path" ]; then
            patterns+=("^$PWD/$path/.*")
        else
            patterns+=("^$PWD/$path\$")
        fi
    done
    say "clang-tidy on ${paths[*]}"
    log="$(mktemp)"
    trap 'rm -f "$log"' EXIT
    run-clang-tidy -quiet -p "$build" -j "$(nproc)" "${patterns[@]}" >"$log" 2>&1 || {
        grep -E '(warning|error):' -A 4 "$log" || tail -n 40 "$log"
        die "clang-tidy found what is listed above"
    }
fi
say "Lint: nothing found"
