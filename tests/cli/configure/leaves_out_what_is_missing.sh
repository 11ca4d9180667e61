# Configuring with no options: -Werror is off, parts whose library is missing are left out and named;
# a part that is asked for and cannot be had is a fault with what to install.
command -v pkg-config >/dev/null || { echo "skipped: no pkg-config"; exit 77; }
# A machine without libpcap, libnats and SDF, as far as can be told.
cat >pkg-config <<'SH'
#!/bin/sh
case "$*" in *libpcap* | *libnats* | *sdformat* | *console_bridge*) exit 1 ;; esac
exec "$REAL_PKG_CONFIG" "$@"
SH
chmod +x pkg-config
REAL_PKG_CONFIG=$(command -v pkg-config)
export REAL_PKG_CONFIG
configure() {
  cmake -S "$SRC" -B build -DROCINANTE_TESTS=OFF -DROCINANTE_GL=OFF \
    -DPKG_CONFIG_EXECUTABLE="$PWD/pkg-config" "$@" >log 2>&1
}
configure || { cat log; exit 1; }
sed -n 's/^-- rocinante: //p' log
grep '^ROCINANTE_WERROR' build/CMakeCache.txt
configure -DROCINANTE_PCAP=ON && echo "configured without libpcap"
tr -s ' \n' ' ' <log | grep -o 'ROCINANTE_PCAP is ON.*=OFF'
