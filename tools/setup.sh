#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what a command of Fixel needs and this machine lacks.
#
# usage: tools/setup.sh [--packages-only|--missing] run|view|report|units|test|lib|lib-riscv|format|fuzz|coverage|rules|tools|simplify|completion|predict|gdb|probe|pico|riscv|api|docs|oracle|cluster|anywhere...
#
#   run     cross compiler, QEMU, Python packages for running boards
#   view    the same, and Python packages for a web page
#   report  the same as run, GMP, and Python packages for plots
#   units   the same as run, and Ruby with CMock
#   test    all of these, where node and npm are there already meshoptimizer too, Chromium, which opens the report, GDB and OpenOCD, pytest, and the
#           compilers that the library is tried with: g++, Clang, GCC for RISC-V (64 MB to
#           fetch, 380 MB on disk), CMake
#   lib     cross compiler
#   lib-riscv GCC for RISC-V
#   format  clang-format
#   fuzz    clang with its sanitizers and coverage tools, Python packages as for run, pytest
#   coverage Clang 19, which counts conditions, with its tools; the same as units
#   rules   cppcheck, Python packages as for run
#   tools   Python packages as for run
#   simplify the same as tools, and node with meshoptimizer, which --simplify needs
#   completion Python packages as for run, and the one that makes completions for a shell
#   predict compiler for the host, Python packages as for run
#   gdb     the same as run, and a GDB that knows Arm
#   probe   the same as run, and OpenOCD
#   pico    the same as run, and node with rp2040js, which emulates the board pico
#   riscv   compiler, C library and QEMU for the board rv32 (70 MB to fetch)
#   api     compiler for the host, and abidiff of libabigail
#   docs    Doxygen (50 MB on disk); Python packages as for run, and for documents
#   site    compiler for the host and cross compiler, Clang, the linker of LLVM and the C library of WASI for WebAssembly, node with esbuild; the same as docs
#   oracle  compiler for the host, GMP, Python packages as for run: what the samples of a report take
#   cluster the same as oracle, and Python packages for plots, tests, and campaigns on a cluster
#   anywhere the same as run, pico, riscv, api and docs, a C++ compiler, CMake, pkg-config, GCC for AVR, which must refuse the library,
#           Clang and the linker of LLVM for WebAssembly, the builder of Arduino, cargo where Debian has one that is new enough, and
#           libclang, by which a crate reads the headers of LVGL
#
# Debian packages come from this machine's own apt sources. Python packages are those of
# requirements/*.txt and go into .venv; axe-core, esbuild, meshoptimizer and rp2040js are those of requirements/package-lock.json and go into .node. Where nothing is missing, set-up says nothing and
# takes less than a second. --missing installs nothing: it prints the packages that are missing. Exit: 0 all there, 1 something is missing.
set -eu
cd "$(dirname "$0")/.."

venv=.venv
node_home=.node
cmock_home=/usr/share/cmock
cross=${CROSS:-arm-none-eabi-}

say() { printf 'setup: %s\n' "$*" >&2; }
die() { say "$*"; exit 1; }
has() { command -v "$1" >/dev/null 2>&1; }
compiles() { printf '#include <%s>\n' "$2" | "$1" -x c -E - >/dev/null 2>&1; }

# --- what is missing ---------------------------------------------------------

packages=
need() { case " $packages " in *" $1 "*) ;; *) packages="$packages $1" ;; esac; }

need_host_compiler() {
    has gcc || need gcc
    compiles gcc stdio.h || need libc6-dev
}
need_cross_compiler() {
    has "${cross}gcc" || need gcc-arm-none-eabi
    compiles "${cross}gcc" string.h || need libnewlib-arm-none-eabi
}
need_emulator() { has qemu-system-arm || need qemu-system-arm; }
need_board() { need_host_compiler; need_cross_compiler; need_emulator; need_python run; }
need_cmock() {
    has ruby || need ruby
    [ -f "$cmock_home/lib/cmock.rb" ] || need cmock
}
need_riscv() {
    has riscv64-unknown-elf-gcc || need gcc-riscv64-unknown-elf
    printf '#include <math.h>\n' | riscv64-unknown-elf-gcc --specs=picolibc.specs -x c -E - >/dev/null 2>&1 ||
        need picolibc-riscv64-unknown-elf
    has qemu-system-riscv32 || need qemu-system-misc
}
# Debian 12 has cargo 1.63, which is too old for the crates: there a newer one is used if it is installed, and else they are not tested.
need_cargo() {
    has cargo || [ "$(. /etc/os-release; echo "$ID:$VERSION_ID")" = debian:12 ] || need cargo
    ls /usr/lib/llvm-*/lib/libclang*.so* >/dev/null 2>&1 || need libclang-dev
}
need_webassembly() { has clang || need clang; has wasm-ld || need lld; }
# The C library of WASI, and the functions that clang calls for long double there.
need_wasi() {
    [ -f /usr/include/wasm32-wasi/stdlib.h ] || need wasi-libc
    ls /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a >/dev/null 2>&1 || need libclang-rt-dev-wasm32
}
need_gmp() { compiles gcc gmp.h || need libgmp-dev; }
need_browser() { has chromium || need chromium; }
need_debugger() { has gdb-multiarch || need gdb-multiarch; }
need_openocd() { has openocd || need openocd; }
need_compilers() {
    has g++ || need g++
    clang=$(find_clang) && has "clang++${clang#clang}" || need clang
    has riscv64-unknown-elf-gcc || need gcc-riscv64-unknown-elf
    has cmake || need cmake
}
# A run-time library has no command of its own: ask the compiler to link one.
need_fuzzer() {
    clang=$(find_clang) || { need clang; need llvm; need libclang-rt-dev; return; }
    has "llvm-cov${clang#clang}" || need llvm
    printf 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return d && !n; }\n' |
        "$clang" -x c -fsanitize=fuzzer,address -o /dev/null - 2>/dev/null || need libclang-rt-dev
}
find_clang() {
    for clang in clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14; do
        if has "$clang"; then echo "$clang"; return; fi
    done
    return 1
}
# Clang counts conditions from version 18 on. Debian 12 and 13 have version 19 beside an older or equal one.
need_coverage() {
    has clang-19 || need clang-19
    has llvm-cov-19 || need llvm-19
    printf 'int main(void) { return 0; }\n' |
        clang-19 -x c -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -o /dev/null - 2>/dev/null ||
        need libclang-rt-19-dev
}
# meshoptimizer and rp2040js. Their stamp is a copy of the lock.
node_is_ready() { cmp -s requirements/package-lock.json "$node_home/.ready"; }
need_node() {
    has node || need nodejs
    has npm || need npm
    node_wanted=yes
}
need_node_where_it_is() { if has node && has npm; then node_wanted=yes; fi; }
# The groups of requirements/ that are wanted.
need_python() {
    for group in "$@"; do
        case " $python_groups " in *" $group "*) ;; *) python_groups="$python_groups $group" ;; esac
    done
}

# The venv's stamp: the interpreter that it was made for, and where. It is found once: a python3 that first looks for the
# real one takes 0.15 s.
key=
venv_key() {
    [ -n "$key" ] || key=$({ python3 -c 'import sys; print(sys.version, sys.executable)'; pwd; } | sha256sum | cut -d' ' -f1)
}
venv_is_made() {
    venv_key
    [ -x "$venv/bin/python" ] && [ "$(cat "$venv/.made" 2>/dev/null)" = "$key" ]
}
# The tools as one program, also in a venv that was made without it.
make_launcher() {
    [ -x "$venv/bin/fixel" ] && return
    printf '%s\n' '#!/bin/sh' 'bin=$(dirname "$0")' 'exec "$bin/python" "$bin/../../tools/fixel/launcher.py" "$@"' \
        >"$venv/bin/fixel.new"
    chmod +x "$venv/bin/fixel.new"
    mv "$venv/bin/fixel.new" "$venv/bin/fixel"
}
# A group's stamp is a copy of its requirements.
missing_groups() {
    for group in $python_groups; do
        cmp -s "requirements/$group.txt" "$venv/.ready-$group" || printf '%s ' "$group"
    done
}
venv_is_ready() { venv_is_made && [ -z "$(missing_groups)" ]; }

find_missing() {
    packages=
    python_groups=
    node_wanted=
    for what in "$@"; do
        case $what in
        run) need_board ;;
        view) need_board; need_python view ;;
        report) need_board; need_gmp; need_python report ;;
        units) need_board; need_cmock ;;
        test)
            need_board; need_gmp; need_cmock; need_browser; need_debugger; need_openocd
            need_compilers; need_node_where_it_is
            need_python view report test completion ;;
        lib) need_cross_compiler ;;
        lib-riscv) has riscv64-unknown-elf-gcc || need gcc-riscv64-unknown-elf ;;
        fuzz) need_host_compiler; need_fuzzer; need_python run test ;;
        format) has clang-format || need clang-format ;;
        coverage) need_board; need_cmock; need_coverage ;;
        rules) has cppcheck || need cppcheck; need_python run ;;
        tools) need_python run ;;
        simplify) need_node; need_python run ;;
        completion) need_python run completion ;;
        predict) need_host_compiler; need_python run ;;
        gdb) need_board; need_debugger ;;
        probe) need_board; need_openocd ;;
        pico) need_board; need_node ;;
        riscv) need_riscv ;;
        api) need_host_compiler; has abidiff || need abigail-tools ;;
        oracle) need_host_compiler; need_gmp; need_python run ;;
        cluster) need_host_compiler; need_gmp; need_python run report test cluster ;;
        docs) has doxygen || need doxygen; need_python run site ;;
        site) need_cross_compiler; need_host_compiler; has doxygen || need doxygen; need_webassembly; need_wasi; need_node; need_python run site ;;
        anywhere)
            need_board; need_riscv; need_node; need_compilers; has pkg-config || need pkg-config; has abidiff || need abigail-tools
            has doxygen || need doxygen; has avr-gcc || need gcc-avr
            has arduino-builder || need arduino-builder; [ -d /usr/share/arduino/hardware/arduino/avr ] || need arduino-core-avr
            need_webassembly; need_cargo ;;
        *) die "unknown set-up '$what': run, view, report, units, test, lib, lib-riscv, format, fuzz, coverage, rules, tools, simplify, completion, predict, gdb, probe, pico, riscv, api, docs, site, oracle, cluster or anywhere" ;;
        esac
    done
    has python3 || need python3
    if [ -n "$python_groups" ] && ! venv_is_made; then
        python3 -c 'import venv, ensurepip' 2>/dev/null || need python3-venv
    fi
}

# --- Debian packages ---------------------------------------------------------

# A folder of this run for logs and exit codes.
make_scratch() {
    scratch=$(mktemp -d "${TMPDIR:-/tmp}/fixel-setup.XXXXXX")
    trap 'rm -rf "$scratch"' EXIT
    trap 'exit 130' INT TERM
}

# Runs apt-get quietly; says how far it is every ten per cent; shows its words if it fails.
apt_run() {
    rm -f "$scratch/apt.exit"
    {
        code=0
        DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -y -o DPkg::Lock::Timeout=300 \
            -o Dpkg::Use-Pty=0 -o APT::Status-Fd=3 "$@" 3>&1 >>"$scratch/apt.log" 2>&1 </dev/null || code=$?
        echo "$code" >"$scratch/apt.exit"
    } | apt_progress
    return "$(cat "$scratch/apt.exit")"
}
apt_progress() {
    last=
    while IFS=: read -r kind _ percent _; do
        case $kind in dlstatus) doing=fetching ;; pmstatus) doing=installing ;; *) continue ;; esac
        now="$doing $(( ${percent%%.*} / 10 ))0 %"
        case $now in "$last" | *" 00 %" | *"100 %") ;; *) say "  $now" ;; esac
        last=$now
    done
}
apt_or_die() {
    apt_run "$@" || { tail -n 15 "$scratch/apt.log" >&2; die "apt-get $1 failed; its words are above"; }
}

candidate() { LC_ALL=C apt-cache policy "$1" 2>/dev/null | grep -q '^  Candidate: [^(]'; }
all_known() { for package in $packages; do candidate "$package" || return 1; done; }

# Debian 12 has no CMock; its mirror serves Debian 13's, which is plain Ruby and
# depends on nothing newer. The pin keeps every other package of Debian 13 out.
add_cmock_source() {
    say "cmock is not in Debian 12: adding suite trixie of this machine's own mirror, for cmock alone"
    say "  (/etc/apt/sources.list.d/fixel-cmock.sources, /etc/apt/preferences.d/fixel-cmock)"
    python3 tools/apt_mirror.py bookworm trixie >"$scratch/cmock.sources" || exit 1
    printf '%s\n' 'Package: *' 'Pin: release n=trixie' 'Pin-Priority: -1' '' \
        'Package: cmock' 'Pin: release n=trixie' 'Pin-Priority: 500' >"$scratch/cmock.pin"
    # The pin goes first: without it the source could reach other packages.
    install -m 644 "$scratch/cmock.pin" /etc/apt/preferences.d/fixel-cmock
    install -m 644 "$scratch/cmock.sources" /etc/apt/sources.list.d/fixel-cmock.sources
    apt_or_die update -o Dir::Etc::sourcelist=/etc/apt/sources.list.d/fixel-cmock.sources \
        -o Dir::Etc::sourceparts=- -o APT::Get::List-Cleanup=0
}
needs_cmock_source() {
    case " $packages " in *" cmock "*) ;; *) return 1 ;; esac
    ! candidate cmock && [ "$(. /etc/os-release; echo "$ID:$VERSION_ID")" = debian:12 ]
}

apt_command="apt-get install -y --no-install-recommends"

# Without root: the one command that somebody with root has to run.
explain_without_root() {
    if needs_cmock_source || ! all_known; then
        command="$PWD/tools/setup.sh --packages-only $*"
    else
        command="$apt_command$packages"
    fi
    say "missing on this machine:$packages"
    say "installing packages needs root. Run this, then try again:"
    if has sudo; then say "  sudo $command"; else say "  su -c '$command'"; fi
    exit 1
}

install_packages() {
    has apt-get || die "missing:$packages, and there is no apt-get here: install them by hand"
    [ "$(id -u)" -eq 0 ] || explain_without_root "$@"
    : >"$scratch/apt.log"
    if ! all_known; then
        say "fetching the lists of packages (about 10 MB)"
        apt_or_die update
        if needs_cmock_source; then add_cmock_source; fi
        all_known || die "not in this machine's apt sources: $(unknown). Add a source that has it."
    fi
    sizes=$(LC_ALL=C apt-get -o Dpkg::Use-Pty=0 --assume-no --no-install-recommends install $packages 2>/dev/null |
        sed -n 's/^Need to get \(.*\) of archives.*/\1 to fetch/p
                s/^After this operation, \(.*\) of additional.*/\1 on disk/p' | paste -sd, | sed 's/,/, /')
    say "installing$packages (${sizes:-sizes unknown})"
    if ! apt_run --no-install-recommends install $packages; then
        # Lists that are too old name files that the mirror no longer has.
        say "fetching fresh lists of packages and trying once more"
        apt_or_die update
        apt_or_die --no-install-recommends install $packages
    fi
}
unknown() { for package in $packages; do candidate "$package" || printf '%s ' "$package"; done; }

# --- Python packages ---------------------------------------------------------

make_venv() {
    say "making .venv"
    python3 -m venv --clear "$venv" || die "python3 -m venv failed; its words are above"
    make_launcher
    venv_key
    echo "$key" >"$venv/.made"
}
# $1: a group.
install_group() {
    say "fetching the Python packages of requirements/$1.txt into .venv"
    rm -f "$venv/.ready-$1"
    {
        code=0
        "$venv/bin/python" -m pip install --disable-pip-version-check --no-input --no-color \
            --progress-bar off --require-hashes -r "requirements/$1.txt" 2>&1 </dev/null || code=$?
        echo "$code" >"$scratch/pip.exit"
    } | tee "$scratch/pip.log" | sed -u -n 's/^Collecting \([^ ]*\).*/setup:   \1/p; s/^Installing collected.*/setup:   installing/p' >&2
    [ "$(cat "$scratch/pip.exit")" -eq 0 ] || {
        tail -n 10 "$scratch/pip.log" >&2
        die "pip could not install requirements/$1.txt; its words are above"
    }
    cp "requirements/$1.txt" "$venv/.ready-$1"
}

# --- packages of node --------------------------------------------------------

install_node() {
    say "fetching axe-core, esbuild, meshoptimizer and rp2040js of requirements/package-lock.json into $node_home"
    mkdir -p "$node_home"
    rm -f "$node_home/.ready"
    cp requirements/package.json requirements/package-lock.json "$node_home/"
    npm ci --prefix "$node_home" --ignore-scripts --no-audit --no-fund --no-progress --loglevel=error >"$scratch/npm.log" 2>&1 </dev/null || {
        tail -n 10 "$scratch/npm.log" >&2
        die "npm could not install requirements/package-lock.json; its words are above"
    }
    cp requirements/package-lock.json "$node_home/.ready"
}

# --- all together ------------------------------------------------------------

packages_only= missing_only=
case "${1-}" in
--packages-only) packages_only=yes; shift ;;
--missing) missing_only=yes; shift ;;
esac
[ $# -gt 0 ] || die "usage: tools/setup.sh [--packages-only|--missing] run|view|report|units|test|lib|lib-riscv|format|fuzz|coverage|rules|tools|simplify|completion|predict|gdb|probe|pico|riscv|api|docs|oracle|cluster|anywhere..."
if [ -n "$missing_only" ]; then
    find_missing "$@"
    printf '%s\n' "${packages# }"
    exit 0
fi

# make test has set up all of this, and then its tests call hundreds of commands of make.
is_of_test() {
    for what in "$@"; do
        case $what in run | view | report | units | test | lib | lib-riscv | tools | simplify | completion | predict | gdb | probe) ;; *) return 1 ;; esac
    done
}
if [ "${FIXEL_SET_UP-}" = "$PWD" ] && is_of_test "$@"; then exit 0; fi

is_ready() {
    find_missing "$@"
    [ -z "$packages" ] && { [ -n "$packages_only" ] || { { [ -z "$python_groups" ] || venv_is_ready; } &&
        { [ -z "$node_wanted" ] || node_is_ready; }; }; }
}
if venv_is_made; then make_launcher; fi
is_ready "$@" && exit 0

exec 9<tools/setup.sh
flock 9                     # two commands at once set up one after the other
make_scratch
is_ready "$@" && exit 0
[ -z "$packages" ] || install_packages "$@"
find_missing "$@"
[ -z "$packages" ] || die "still missing after installing:$packages. Is PATH set as usual?"
if [ -n "$python_groups" ] && [ -z "$packages_only" ]; then
    venv_is_made || make_venv
    for group in $(missing_groups); do install_group "$group"; done
fi
if [ -n "$node_wanted" ] && [ -z "$packages_only" ] && ! node_is_ready; then install_node; fi
say "ready"
