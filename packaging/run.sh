#!/usr/bin/env bash
# Installs what is missing, builds Kickstand and starts it. Arguments go to the program:
#   packaging/run.sh --link sim:thunderbots
# With no display it runs the tour offscreen and names the folder of pictures.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# True when an argument asks for something that needs no display of its own.
asks_for_no_window() {
    local argument
    for argument in "$@"; do
        case "$argument" in
            --tour | --tour=* | -h | --help | -v | --version) return 0 ;;
        esac
    done
    return 1
}

build() {
    use_ccache
    # Configured once; after that the build itself sees what changed. Programs only: no tests, so no test packages.
    if [ ! -e build/release/build.ninja ]; then
        say "Configuring build/release"
        cmake --preset release -DKICKSTAND_TESTS=OFF -DKICKSTAND_BENCH=OFF ||
            die "CMake could not configure the build; its own words are above."
    fi
    say "Building (a first build takes some minutes)"
    cmake --build --preset release --parallel "$(nproc)" --target kickstand kickstandctl ||
        die "the build failed; the compiler's words are above."
}

install_packages packaging/packages-run.txt
build

program=build/release/app/kickstand
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}${QT_QPA_PLATFORM:-}" ]; then
    say "Starting $program $*"
    exec "$program" "$@"
fi

export QT_QPA_PLATFORM=offscreen
if asks_for_no_window "$@"; then
    exec "$program" "$@"
fi
say "There is no display (neither DISPLAY nor WAYLAND_DISPLAY is set): running the tour offscreen instead${*:+, without $*}"
mkdir -p build/tour
"$program" --tour build/tour || die "the tour failed with exit code $?; its own words are above."
say "The pictures of the tour are in $PWD/build/tour"
