# Sourced by ./wend, ./test and .ci/run: installs missing packages and builds. Quick when nothing changed.
# setup PURPOSE…: installs the packages for these purposes.   build TARGET…: configures if needed and builds.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$root/build/release
. "$root/scripts/progress.sh"

packages_for() { # PURPOSE…
    local purposes=" $* "
    while read -r purpose package; do
        case "$purposes" in *" $purpose "*) echo "$package" ;; esac
    done < <(grep -v '^#' "$root/scripts/packages.txt")
}

missing_of() { # PACKAGE…
    local installed
    installed=" $(dpkg-query -W -f '${Package}=${db:Status-Status} ' "$@" 2>/dev/null) "
    for package in "$@"; do
        case "$installed" in *" $package=installed "*) ;; *) echo "$package" ;; esac
    done
}

setup() { # PURPOSE…
    local wanted missing sudo=
    mapfile -t wanted < <(packages_for "$@")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        [ -e "$build_dir/build.ninja" ] && return
        echo "This is not a Debian system. Please install what these Debian 12 packages hold, then run" >&2
        echo "  cmake --preset release && cmake --build --preset release" >&2
        printf '  %s\n' "${wanted[@]}" >&2
        return 1
    fi
    mapfile -t missing < <(missing_of "${wanted[@]}")
    [ "${#missing[@]}" -eq 0 ] && return
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "Please install as root: apt-get install ${missing[*]}" >&2; return 1; }
        sudo=sudo
    fi
    echo "Installing: ${missing[*]}" >&2
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get update -q >&2 &&
        $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" >&2
}

configure() { # PRESET OPTION…: prints the output of cmake only if it fails
    local log
    log=$(mktemp)
    echo "Configuring." >&2
    if ! (cd "$root" && cmake --preset "$@") >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}

configured_with() { # NAME=VALUE…: succeeds if the build has these settings
    [ -e "$build_dir/build.ninja" ] || return 1
    for setting in "$@"; do
        grep -q "^${setting%%=*}:BOOL=${setting#*=}\$" "$build_dir/CMakeCache.txt" || return 1
    done
}

build() { # TARGET…
    local settings=("WEND_WERROR=${WEND_WERROR:-OFF}") when=again
    [ -z "${WEND_LIBRARY:-}" ] || settings+=("WEND_LIBRARY=$WEND_LIBRARY")
    [ -e "$build_dir/.ninja_log" ] || when=first
    configured_with "${settings[@]}" || configure release "${settings[@]/#/-D}" || return 1
    NINJA_STATUS='[%f/%t] ' ninja -C "$build_dir" "$@" 2>&1 | narrate_build "$when" >&2
    return "${PIPESTATUS[0]}"
}
