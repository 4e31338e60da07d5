# Runs in the guest, as root. Uses the simulated dongle through the kernel's USB stack and unmodified libusb, and asks the
# simulator, which runs on the host, what its robots received. A line a check: "ok WHAT" or "FAILED WHAT".
. /run/exchange/settings

failures=0
questions=0
answer=
cp "$programs/kickstandctl" /tmp/kickstandctl
chmod 755 /tmp/kickstandctl

ok() { echo "ok      $*"; }
failed() {
    failures=$((failures + 1))
    echo "FAILED  $*"
    printf '%s\n' "$answer" | sed 's/^/        /' | head -n 30
}

# ask WORD... : has the host do "kickstand-sim ctl WORD..."; what it said is in $answer.
ask() {
    questions=$((questions + 1))
    printf '%s\n' "$@" >/run/exchange/part
    mv /run/exchange/part "/run/exchange/ask.$questions"
    local tries=0
    until [ -e "/run/exchange/answer.$questions" ]; do
        tries=$((tries + 1))
        [ $tries -lt 1200 ] || {
            answer="the host did not answer within a minute"
            return
        }
        sleep 0.05
    done
    answer=$(cat "/run/exchange/answer.$questions")
}

# ctl WORD... : kickstandctl on the dongle; $answer and $code are what came of it.
ctl() {
    answer=$(/tmp/kickstandctl --link usb: "$@" 2>&1)
    code=$?
}
# as GROUPS WORD... : the same as a person who is not root.
as() {
    local groups=$1
    shift
    answer=$(setpriv --reuid=65534 --regid=65534 "$groups" /tmp/kickstandctl --link usb: "$@" 2>&1)
    code=$?
}

has() { printf '%s\n' "$answer" | grep -qF -- "$1"; }
# expect WHAT TEXT... : every text is in $answer.
expect() {
    local what=$1 text
    shift
    for text in "$@"; do
        has "$text" || {
            failed "$what: no $text"
            return
        }
    done
    ok "$what"
}
# ended CODE WHAT : the last ctl ended with this code.
ended() {
    if [ "$code" = "$1" ]; then ok "$2"; else failed "$2: exit code $code instead of $1"; fi
}
# soon WHAT TEXT WORD... : asks the simulator until the text is in its answer, for ten seconds at most.
soon() {
    local what=$1 text=$2 tries=0
    shift 2
    ask "$@"
    until has "$text" || [ $tries -gt 50 ]; do
        tries=$((tries + 1))
        sleep 0.2
        ask "$@"
    done
    expect "$what" "$text"
}

# logged COUNT TEXT : waits until the monitor has told so often of it, for a minute at most.
logged() {
    local tries=0
    until [ "$(grep -cF -- "$2" /tmp/monitor.log)" -ge "$1" ]; do
        tries=$((tries + 1))
        [ $tries -lt 600 ] || return 1
        sleep 0.1
    done
}

attach() {
    local tries=0
    "$tools/usbip" --tcp-port "$port" attach -r 10.0.2.2 -b 1-1 || return 1
    until cat /sys/bus/usb/devices/[0-9]*-[0-9]*/bConfigurationValue 2>/dev/null | grep -q .; do
        tries=$((tries + 1))
        [ $tries -lt 200 ] || return 1
        sleep 0.05
    done
    "$tools/udevadm" settle --timeout=10
}
gone() {
    local tries=0
    while compgen -G '/sys/bus/usb/devices/[0-9]*-[0-9]*/bConfigurationValue' >/dev/null; do
        tries=$((tries + 1))
        [ $tries -lt 200 ] || return 1
        sleep 0.05
    done
}

echo "Linux $(uname -r), emulated"
mkdir -p /etc/udev/rules.d
"$tools/systemd-udevd" --daemon --resolve-names=early >/dev/null 2>&1
if attach; then ok "usbip attach"; else
    failed "usbip attach"
    exit 1
fi
answer=$(cat /sys/bus/usb/devices/[0-9]*-[0-9]*/{idVendor,idProduct,manufacturer,product,speed} 2>/dev/null)
expect "the kernel's enumeration" 04d8 7839 "UBC Thunderbots Robocup Small Size Team" "Thunderbots XBee Dongle" 12

# ---- Permissions and the udev rule.
plugdev=$(getent group plugdev | cut -d: -f3)
as --clear-groups doctor
ended 1 "doctor without permission and without a rule"
expect "its remedy" "Install the udev rule" "sudo tee /etc/udev/rules.d/60-kickstand.rules"
cp "$rule" /etc/udev/rules.d/
# udev looks for new rules every few seconds, and udevadm does nothing in a chroot: out, and in again.
"$tools/usbip" detach -p 0
gone
sleep 4
if attach; then ok "attached again"; else failed "attached again"; fi
as --clear-groups doctor
ended 1 "doctor for somebody whom the rule does not let in"
expect "its remedy" "The udev rule is there (/etc/udev/rules.d/60-kickstand.rules)" "usermod -aG plugdev"
as "--groups=$plugdev" doctor
ended 0 "doctor for a member of plugdev, by the udev rule"

# ---- What the robots are told.
ctl --json thunderbots status
ended 0 "status"
expect "radios" '"radios":"running"'
heard=$(printf '%s\n' "$answer" | grep -o '"live":true' | wc -l)
if [ "$heard" = 3 ]; then ok "three robots are heard"; else failed "three robots are heard: $heard"; fi

/tmp/kickstandctl --link usb: thunderbots drive --robot 3 --wheels 40,0,-40,7 --for 8 >/tmp/drive.log 2>&1 &
drive=$!
soon "drive reaches robot 3" '"wheels":[40,0,-40,7]' --json show 3
ask --json show 5
expect "and no other" '"run":false' '"wheels":[0,0,0,0]'
wait $drive
code=$?
answer=$(cat /tmp/drive.log)
ended 0 "drive for eight seconds"
soon "it is braked after that" '"run":false' --json show 3

/tmp/kickstandctl --link usb: --json thunderbots monitor --for 300 >/tmp/monitor.log 2>&1 &
monitor=$!
logged 1 '"connected"'
ctl thunderbots status
ended 1 "a second program"
expect "is told that another one has it" "another program holds it"
ctl doctor
expect "doctor says which" "held by kickstandctl (process $monitor)"
kill -INT $monitor
wait $monitor

ctl thunderbots kick --robot 3 --width1 2016 --width2 1024 --offset 320
ended 0 "kick"
soon "both pulses arrive, solenoid 2 later by 320 µs" '"start1_us":0,"start2_us":320' --json show 3
expect "as wide as they were asked for" '"width1_us":2016,"width2_us":1024'

/tmp/kickstandctl --link usb: thunderbots autokick --robot 5 --width1 1600 --for 6 >/tmp/autokick.log 2>&1 &
autokick=$!
soon "autokick is armed" '"armed":true' --json show 5
ask ball 5 1
soon "a ball sets it off" '"automatic":1' --json show 5
expect "with the width that was asked for" '"width1_us":1600'
ask ball 5 0
wait $autokick
code=$?
answer=$(cat /tmp/autokick.log)
ended 0 "autokick for six seconds"
soon "it is disarmed after that" '"armed":false' --json show 5

ctl thunderbots test-mode --robot 3 --class hall --target 2
ended 0 "test-mode"
soon "the robot shows it" '"test_mode":{"class":"hall","target":2}' --json show 3

# ---- Firmware. Any bytes will do for the FPGA's; padded as flash reads where nothing was written.
head -c 20000 "$programs/kickstandctl" >/tmp/image.bin
ctl thunderbots flash --robot 0 --target fpga --yes /tmp/image.bin
ended 0 "flash"
ask flash 0 "$exchange/flash.0"
cmp -n 20000 /tmp/image.bin /run/exchange/flash.0 >/dev/null && ok "the robot's flash holds the image" ||
    failed "the robot's flash holds the image"
blank=$(tail -c +20001 /run/exchange/flash.0 | tr -d '\377' | wc -c)
if [ "$blank" = 0 ]; then ok "and nothing else"; else failed "and nothing else: $blank bytes"; fi
ctl thunderbots verify --robot 0 --target fpga /tmp/image.bin
ended 0 "verify"

# ---- The plug.
/tmp/kickstandctl --link usb: thunderbots drive --robot 3 --wheels 30,30,30,30 --for 300 >/tmp/drive.log 2>&1 &
drive=$!
ask --json show 3
kicks=$(printf '%s\n' "$answer" | grep -o '"kicks":{[^}]*' | head -n 1)
soon "it drives" '"wheels":[30,30,30,30]' --json show 3
ask unplug
wait $drive
code=$?
answer=$(cat /tmp/drive.log)
ended 1 "unplugged in mid-drive"
soon "the robot stands" '"wheel_speeds":[0,0,0,0]' --json show 3
if gone; then ok "the kernel lets it go"; else failed "the kernel lets it go"; fi
ctl thunderbots status
ended 1 "status without a dongle"
ask replug
if attach; then ok "plugged in again"; else failed "plugged in again"; fi
ctl thunderbots status
ended 0 "status again"
ask --json show 3
expect "nothing is replayed" '"run":false' '"wheel_speeds":[0,0,0,0]' "$kicks"

/tmp/kickstandctl --link usb: --json thunderbots monitor --for 300 >/tmp/monitor.log 2>&1 &
monitor=$!
logged 1 '"connected"'
ask unplug
gone
ask replug
attach
logged 2 '"connected"'
code=$?
answer=$(tail -n 5 /tmp/monitor.log)
ended 0 "one program goes on over unplug and replug"
kill -INT $monitor
wait $monitor

[ "$failures" = 0 ]
