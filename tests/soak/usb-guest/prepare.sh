#!/usr/bin/env bash
# Makes what the guest boots: Debian's own kernel and a small first file system with the modules for USB/IP. Downloads some
# 75 MB of Debian packages once, and installs nothing but unpacks them.   prepare.sh CACHE_FOLDER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cache=$1
modules=(virtio_pci virtio_net 9p 9pnet_virtio overlay vhci_hcd)

mkdir -p "$cache/packages"
cd "$cache"
kernel_package=$(apt-cache depends linux-image-amd64 | sed -n 's/.*Depends: \(linux-image-[0-9].*\)/\1/p' | head -n 1)
[ -n "$kernel_package" ] || {
    echo "prepare.sh: apt knows no linux-image-amd64; run apt-get update first" >&2
    exit 1
}
(
    cd packages
    for package in "$kernel_package" busybox-static usbip udev; do
        compgen -G "${package}_*.deb" >/dev/null || apt-get -q download "$package"
    done
    for file in *.deb; do
        [ -d "${file%.deb}" ] || dpkg-deb -x "$file" "${file%.deb}"
    done
)
unpacked() { printf '%s\n' "$cache/packages/$1"_*/ | tail -n 1; }
kernel=$(unpacked "$kernel_package")
version=$(ls "$kernel/lib/modules")
cp "$kernel/boot/vmlinuz-$version" kernel

rm -rf root tools
mkdir -p root/{bin,proc,sys,dev,host,lower,upper,lib/modules/"$version"} tools
cp "$(unpacked busybox-static)/bin/busybox" root/bin/
cp "$here/init" root/init
# The tools that the guest's programs run: they come from the packages, so that this machine needs none of them.
cp -r "$(unpacked usbip)usr/sbin" tools/
cp "$(unpacked udev)bin/udevadm" tools/sbin/
# The daemon is the same program under another name.
ln -sf udevadm tools/sbin/systemd-udevd

# A module and, first, what it depends on; busybox's modprobe in the guest reads the same list.
cp -r "$kernel/lib/modules/$version/kernel" root/lib/modules/"$version"/all
"$cache/root/bin/busybox" depmod -b "$cache/root" "$version"
mapfile -t needed < <(
    for module in "${modules[@]}"; do
        sed -n "s|^\(\S*/${module//_/[-_]}\.ko\):|\1|p" "root/lib/modules/$version/modules.dep"
    done | tr ' ' '\n' | sed '/^$/d' | sort -u
)
(
    cd root/lib/modules/"$version"
    for file in "${needed[@]}"; do
        mkdir -p "kept/$(dirname "$file")"
        cp "$file" "kept/$file"
    done
    rm -rf all
    mv kept/all all
    rmdir kept
)
"$cache/root/bin/busybox" depmod -b "$cache/root" "$version"
printf '%s\n' "${modules[@]}" >root/modules
(cd root && find . | bin/busybox cpio -o -H newc 2>/dev/null | gzip -1 >../initramfs)
echo "$kernel_package" >prepared
