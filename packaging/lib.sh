# shellcheck shell=bash
# Shared by the scripts of this folder; sourced, not run. What they have in common: they work from the root of the
# checkout, say what they do, install only what is missing, and stop with one line that says what to do.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ -t 1 ]; then
    bold=$'\e[1m' red=$'\e[31m' plain=$'\e[0m'
else
    bold='' red='' plain=''
fi

# say WORD... : a heading with the seconds since the script began.
say() {
    printf '%s==> [%4d s] %s%s\n' "$bold" "$SECONDS" "$*" "$plain"
}

# die WORD... : one clear line on standard error, and the end.
die() {
    printf '%s%s: %s%s\n' "$red" "$(basename "$0")" "$*" "$plain" >&2
    exit 1
}

# missing_packages FILE... : the packages named in the files that are not installed, one a line.
missing_packages() {
    local package
    while read -r package; do
        # shellcheck disable=SC2016  # the dollar belongs to dpkg-query
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
    done < <(sed 's/#.*//; /^[[:space:]]*$/d' "$@")
}

# as_root COMMAND... : through sudo where needed.
as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

# need_root PACKAGE... : stops here, before anything has been tried, where root is out of reach.
need_root() {
    [ "$(id -u)" = 0 ] && return
    command -v sudo >/dev/null ||
        die "packages are missing, and there is no sudo. As root: apt-get install --no-install-recommends $*"
    # With no terminal nobody can type a password.
    [ -t 0 ] || sudo -n true 2>/dev/null ||
        die "packages are missing, and sudo wants a password, which nobody can type here. Run: sudo apt-get install --no-install-recommends $*"
}

# install_packages FILE... : installs through apt what the files name and this machine lacks.
# KICKSTAND_SKIP_INSTALL=1 leaves the machine as it is, for systems that name their packages otherwise.
install_packages() {
    if [ "${KICKSTAND_SKIP_INSTALL:-0}" = 1 ]; then
        say "Packages: not looked at (KICKSTAND_SKIP_INSTALL=1)"
        return
    fi
    command -v apt-get >/dev/null ||
        die "there is no apt here. Install what $* name in your system's way, then set KICKSTAND_SKIP_INSTALL=1"

    local missing
    mapfile -t missing < <(missing_packages "$@")
    if [ "${#missing[@]}" = 0 ]; then
        say "Packages: everything is installed"
        return
    fi
    say "Packages: installing ${missing[*]}"
    need_root "${missing[@]}"

    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Acquire::Retries=2 -o Dpkg::Use-Pty=0)
    # A list that cannot be refreshed is no reason to stop yet: what is needed may be in the others.
    as_root "${apt[@]}" -o APT::Update::Error-Mode=any update ||
        printf 'apt could not refresh all of its package lists; trying with those that are here.\n' >&2
    as_root "${apt[@]}" install --no-install-recommends "${missing[@]}" ||
        die "apt could not install what is missing (its own words are above). Without a network, bring these by hand: ${missing[*]}"
}

# use_ccache : where ccache is installed, a build that was done before takes seconds.
use_ccache() {
    if command -v ccache >/dev/null; then
        export CMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}"
    fi
}
