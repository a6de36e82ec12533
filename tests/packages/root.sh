# To be sourced: clean Debian systems in folders.

# require_roots: leaves with 77, and says why, where there can be none.
require_roots() {
    [ "$(id -u)" -eq 0 ] || { echo "skipped: only root can change into another root"; exit 77; }
    command -v mmdebstrap > /dev/null || { echo "skipped: no mmdebstrap"; exit 77; }
    timeout 60 perl -MIO::Socket::INET -e \
        'exit !IO::Socket::INET->new(PeerAddr => "deb.debian.org:80", Timeout => 50)' ||
        { echo "skipped: deb.debian.org cannot be reached"; exit 77; }
}

# make_root FOLDER ARCHIVE: a Debian 12 with nothing but what every Debian has. It is fetched into
# ARCHIVE once and kept there for a week.
make_root() {
    local folder=$1 archive=$2
    if [ -z "$(find "$archive" -mtime -7 2> /dev/null)" ]; then
        mkdir -p "$(dirname "$archive")"
        mmdebstrap --quiet --variant=minbase bookworm "$archive.part.tar"
        mv "$archive.part.tar" "$archive"
    fi
    mkdir -p "$folder"
    tar -C "$folder" -xf "$archive"
    cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
    # As in a container: no questions, nothing that is only recommended, nothing kept of what is fetched;
    # and no waiting for the disk.
    cat > "$folder/etc/apt/apt.conf.d/tests" << 'END'
APT::Get::Assume-Yes "true";
APT::Install-Recommends "false";
APT::Keep-Downloaded-Packages "false";
Dir::Cache::pkgcache "";
Dir::Cache::srcpkgcache "";
END
    echo force-unsafe-io > "$folder/etc/dpkg/dpkg.cfg.d/tests"
}

# in_root FOLDER PLACE COMMAND: runs a command of the shell in a root.
in_root() {
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        chroot "$1" bash -euo pipefail -c "cd $2 && $3"
}
