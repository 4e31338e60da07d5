#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/link/usb_types.h"

/// USB/IP 1.1.1 as it travels on a TCP connection: messages of both directions to and from bytes. Numbers are
/// big-endian. Pure; any thread. Parsers take any bytes and never look past what they were given.
namespace kickstand::usbip {

constexpr std::uint16_t kVersion = 0x0111;
constexpr std::uint16_t kDefaultPort = 3240;
/// The longest transfer that is taken or asked for; a full-speed device needs far less.
constexpr std::size_t kMaxTransferBytes = 65536;
/// The longest list of devices that is read, and the most interfaces of one device.
constexpr std::size_t kMaxDevices = 256;
constexpr std::size_t kMaxInterfaces = 32;
constexpr std::size_t kMaxBusIdLength = 31;

/// What a parser found at the front of its bytes.
struct Parse {
    enum class Status : std::uint8_t {
        Complete,    ///< One message; `bytes` is its length.
        MoreNeeded,  ///< `bytes` are needed before it makes sense to ask again; more than were given.
        Malformed,   ///< No sense can be made of it, or of anything that follows; `why` says what was wrong.
    };
    Status status = Status::Malformed;
    std::size_t bytes = 0;
    const char* why = "";
};

/// What a server answers to a request for a list or a device.
enum class OpStatus : std::uint32_t {
    Ok = 0,
    NotAvailable = 1,
    Busy = 2,
    DeviceError = 3,
    NoDevice = 4,
    Error = 5
};

/// As Linux numbers them; a device of this project is always FullSpeed.
enum class Speed : std::uint32_t { Unknown = 0, LowSpeed = 1, FullSpeed = 2, HighSpeed = 3, SuperSpeed = 5 };

/// Class, subclass and protocol of one interface.
struct InterfaceClass {
    std::uint8_t deviceClass = 0;
    std::uint8_t subclass = 0;
    std::uint8_t protocol = 0;
    friend bool operator==(const InterfaceClass&, const InterfaceClass&) = default;
};

/// An exported device as lists and imports describe it. `interfaces` is empty in the answer to an import.
struct Device {
    std::string path;   ///< Its place in the server's /sys; at most 255 bytes travel.
    std::string busId;  ///< "1-1"; at most kMaxBusIdLength bytes travel.
    std::uint32_t bus = 0;
    std::uint32_t number = 0;
    Speed speed = Speed::FullSpeed;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t release = 0;
    InterfaceClass deviceClass;
    std::uint8_t configuration = 0;
    std::uint8_t configurations = 1;
    std::vector<InterfaceClass> interfaces;

    std::uint32_t id() const { return bus << 16 | number; }
    friend bool operator==(const Device&, const Device&) = default;
};

// ------------------------------------------------------------------ before an import, one message each way

/// What a client opens a connection with.
struct Request {
    enum class Kind : std::uint8_t { List, Import };
    Kind kind = Kind::List;
    std::string busId;  ///< Of an import.
};

std::vector<std::uint8_t> encodeRequest(const Request& request);
Parse parseRequest(ByteView bytes, Request& request);

std::vector<std::uint8_t> encodeDeviceList(std::span<const Device> devices);
Parse parseDeviceList(ByteView bytes, OpStatus& status, std::vector<Device>& devices);

/// `device` is sent with status Ok alone.
std::vector<std::uint8_t> encodeImportReply(OpStatus status, const Device& device);
Parse parseImportReply(ByteView bytes, OpStatus& status, Device& device);

// ------------------------------------------------------------------ after it, until the connection ends

/// The flag of an OUT transfer that wants a zero-length packet after a last packet of full size.
constexpr std::uint32_t kZeroPacketFlag = 0x40;

/// A client's command: do a transfer, or leave off one that was asked for.
struct Command {
    enum class Kind : std::uint8_t { Submit, Unlink };
    Kind kind = Kind::Submit;
    std::uint32_t sequence = 0;
    std::uint32_t device = 0;
    std::uint8_t endpoint = 0;  ///< As an address: 0x85 is IN 5. 0 or 0x80 for control.
    // Of a submit.
    std::uint32_t flags = 0;
    std::uint32_t length = 0;  ///< Bytes to send, or asked for at most; at most kMaxTransferBytes.
    std::uint32_t interval = 0;
    UsbSetup setup;
    ByteView data{};  ///< To be sent; empty for IN. Points into what was parsed or is encoded.
    // Of an unlink.
    std::uint32_t unlink = 0;  ///< The sequence number of the transfer to leave off.
};

std::vector<std::uint8_t> encodeCommand(const Command& command);
/// Isochronous transfers are Malformed: no device here has such an endpoint.
Parse parseCommand(ByteView bytes, Command& command);

/// Linux's negative errno values that travel as the status of a transfer, whatever the platform.
enum class TransferStatus : std::int32_t {
    Ok = 0,
    NoEntry = -2,      ///< ENOENT: left off by the server's side.
    NoDevice = -19,    ///< ENODEV.
    Invalid = -22,     ///< EINVAL.
    Stall = -32,       ///< EPIPE.
    Protocol = -71,    ///< EPROTO.
    Overflow = -75,    ///< EOVERFLOW.
    Reset = -104,      ///< ECONNRESET: unlinked.
    Shutdown = -108,   ///< ESHUTDOWN: the device was disconnected.
    TimedOut = -110,   ///< ETIMEDOUT.
    ShortRead = -121,  ///< EREMOTEIO.
};

/// A server's answer. Whether bytes follow an answer to a submit is known only from what was asked.
struct Reply {
    Command::Kind kind = Command::Kind::Submit;
    std::uint32_t sequence = 0;
    TransferStatus status = TransferStatus::Ok;  ///< May be a number that has no name here.
    std::uint32_t actual = 0;  ///< Of a submit: bytes that moved, at most kMaxTransferBytes.
};

constexpr std::size_t kReplySize = 48;

/// `data` follows the answer to an IN transfer; empty for all others.
std::vector<std::uint8_t> encodeReply(const Reply& reply, ByteView data = {});
/// The 48 bytes alone; where the transfer was IN, `reply.actual` bytes of data follow.
Parse parseReply(ByteView bytes, Reply& reply);

}  // namespace kickstand::usbip
