# scripts/setup on a release that lacks some names: alternatives are taken, what is left out is said
# once, and a required package that apt does not know is named.
cat >apt-cache <<'SH'
#!/bin/bash
for name in "${@:2}"; do
  case " $UNKNOWN " in *" $name "*) ;; *) printf '%s:\n  Installed: (none)\n  Candidate: 1.0\n' "$name" ;; esac
done
SH
# Everything is installed but what is in ABSENT.
cat >dpkg-query <<'SH'
#!/bin/bash
for name in $(awk '!/^#/ && NF { print $1 }' "$SRC/scripts/packages.txt" | tr '|' ' '); do
  case " $ABSENT " in *" $name "*) ;; *) echo "ii  $name" ;; esac
done
SH
printf '#!/bin/sh\necho "apt-get $*" >>"$APT_LOG"\n' >apt-get
printf '#!/bin/sh\necho 0\n' >id
chmod +x apt-cache dpkg-query apt-get id
export APT_LOG=$PWD/apt-get.log
PATH=$PWD:$PATH
export UNKNOWN ABSENT
setup() {
  "$SRC/scripts/setup" "$@" 2>&1 | sed 's/apt on .* \(does not know\|knows no\)/apt on RELEASE \1/; s/in [0-9]* s$/in N s/'
}

UNKNOWN="" ABSENT=""
echo "-- a release with every first name"
setup
setup --list | grep -E '^(clang|libsdformat)'
echo "-- one without some"
UNKNOWN="clang-14 libfuzzer-14-dev libclang-rt-14-dev libsdformat-dev"
setup
setup --list | grep -E 'clang-[0-9]+$|fuzzer|clang-rt|libsdformat' || true
echo "-- an alternative is missing"
ABSENT=clang-19
setup
echo "-- without a required one"
UNKNOWN="clang-14 clang-19 clang-22 clang" ABSENT=""
setup || echo "exit $?"
echo "-- what was asked of apt-get"
sed 's/-o [^ ]*=[0-9]* //' apt-get.log
echo "-- another apt holds the lists"
cat >apt-get <<'SH'
#!/bin/sh
case $* in *update*) [ -e "$APT_LOG.tried" ] || { touch "$APT_LOG.tried"; echo "E: Could not get lock /var/lib/apt/lists/lock"; exit 100; } ;; esac
SH
UNKNOWN="" ABSENT=clang-14
setup
