#include "core/link/usbip/usbip_wire.h"

#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/base/hex.h"

namespace kickstand::usbip {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using Status = Parse::Status;

struct DataFile {
    std::string parser;
    std::string why;
    Bytes bytes;
};

fs::path folder(const char* name) {
    return fs::path(KICKSTAND_USBIP_DATA) / name;
}

DataFile load(const fs::path& path) {
    DataFile file;
    std::ifstream in(path);
    EXPECT_TRUE(in.good()) << path;
    for (std::string line; std::getline(in, line);) {
        const std::size_t space = line.find(' ');
        const std::string word = line.substr(0, space);
        const std::string value = line.substr(space + 1);
        if (word == "parser") file.parser = value;
        if (word == "why") file.why = value;
        if (word != "bytes") continue;
        const auto bytes = parseHex(value);
        EXPECT_TRUE(bytes) << path << ": " << value;
        if (bytes) file.bytes.insert(file.bytes.end(), bytes->begin(), bytes->end());
    }
    return file;
}

Bytes golden(const std::string& name) {
    return load(folder("golden") / (name + ".usbip")).bytes;
}

Parse parseAs(const std::string& parser, ByteView bytes) {
    OpStatus status{};
    if (parser == "request") {
        Request request;
        return parseRequest(bytes, request);
    }
    if (parser == "list") {
        std::vector<Device> devices;
        return parseDeviceList(bytes, status, devices);
    }
    if (parser == "import") {
        Device device;
        return parseImportReply(bytes, status, device);
    }
    if (parser == "command") {
        Command command;
        return parseCommand(bytes, command);
    }
    EXPECT_EQ(parser, "reply");
    Reply reply;
    return parseReply(bytes, reply);
}

std::vector<fs::path> filesOf(const char* name) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder(name)))
        files.push_back(entry.path());
    return files;
}

Device dongle() {
    Device device;
    device.path = "/sys/devices/virtual/usb/1-1";
    device.busId = "1-1";
    device.bus = 1;
    device.number = 2;
    device.vendor = 0xC1CA;
    device.product = 0x0004;
    device.release = 0x0100;
    device.deviceClass = {0xFF, 1, 2};
    device.configurations = 1;
    return device;
}

TEST(UsbipWire, RequestsAreAsTheProtocolHasThem) {
    EXPECT_EQ(encodeRequest({}), golden("request-list"));
    EXPECT_EQ(encodeRequest({Request::Kind::Import, "1-1"}), golden("request-import"));
    Request request;
    EXPECT_EQ(parseRequest(golden("request-import"), request).bytes, 40U);
    EXPECT_EQ(request.kind, Request::Kind::Import);
    EXPECT_EQ(request.busId, "1-1");
    EXPECT_EQ(parseRequest(golden("request-list"), request).bytes, 8U);
    EXPECT_EQ(request.kind, Request::Kind::List);
}

TEST(UsbipWire, ListsAreAsTheProtocolHasThem) {
    OpStatus status = OpStatus::Error;
    std::vector<Device> devices;
    EXPECT_EQ(parseDeviceList(golden("list-empty"), status, devices).status, Status::Complete);
    EXPECT_EQ(status, OpStatus::Ok);
    EXPECT_TRUE(devices.empty());
    EXPECT_EQ(encodeDeviceList({}), golden("list-empty"));

    Device device = dongle();
    device.interfaces = {{0xFF, 0, 0}, {0xFE, 1, 2}};
    // The golden one has two interfaces in its description, the import's too.
    EXPECT_EQ(encodeDeviceList(std::vector{device}), golden("list-one"));
    EXPECT_EQ(parseDeviceList(golden("list-one"), status, devices).status, Status::Complete);
    EXPECT_EQ(devices, std::vector{device});
}

TEST(UsbipWire, AnswersToImportsAreAsTheProtocolHasThem) {
    OpStatus status = OpStatus::Error;
    Device device;
    EXPECT_EQ(parseImportReply(golden("import-ok"), status, device).bytes, 320U);
    EXPECT_EQ(status, OpStatus::Ok);
    EXPECT_EQ(device, dongle());
    EXPECT_EQ(device.id(), 0x10002U);
    EXPECT_EQ(parseImportReply(golden("import-busy"), status, device).bytes, 8U);
    EXPECT_EQ(status, OpStatus::Busy);
    EXPECT_EQ(encodeImportReply(OpStatus::Busy, {}), golden("import-busy"));
    Device described = dongle();
    described.interfaces.resize(2);
    EXPECT_EQ(encodeImportReply(OpStatus::Ok, described), golden("import-ok"));
}

Command base(std::uint32_t sequence, std::uint8_t endpoint, std::uint32_t length) {
    Command command;
    command.sequence = sequence;
    command.device = 0x10002;
    command.endpoint = endpoint;
    command.length = length;
    return command;
}

void expectCommand(const Command& expected, const std::string& name) {
    const Bytes bytes = golden(name);
    EXPECT_EQ(encodeCommand(expected), bytes) << name;
    Command parsed;
    const Parse parse = parseCommand(bytes, parsed);
    ASSERT_EQ(parse.status, Status::Complete) << name;
    EXPECT_EQ(parse.bytes, bytes.size());
    EXPECT_EQ(parsed.kind, expected.kind);
    EXPECT_EQ(parsed.endpoint & 0x0F, expected.endpoint & 0x0F);
    EXPECT_EQ(encodeCommand(parsed), bytes) << name;
}

TEST(UsbipWire, CommandsAreAsTheProtocolHasThem) {
    Command command = base(1, 0x80, 18);
    command.setup = {0x80, 6, 0x0100, 0, 18};
    expectCommand(command, "submit-control-in");
    command = base(2, 0x00, 0);
    command.setup = {0x00, 9, 1, 0, 0};
    expectCommand(command, "submit-control-out");
    const Bytes data{0x80, 0x7F, 0xE0};
    command = base(0x010203, 0x05, 3);
    command.interval = 1;
    command.data = data;
    expectCommand(command, "submit-interrupt-out");
    command = base(0xFFFFFFFF, 0x85, 64);
    command.interval = 1;
    expectCommand(command, "submit-interrupt-in");
    command = base(0x010204, 0x00, 0);
    command.kind = Command::Kind::Unlink;
    command.unlink = 0x010203;
    expectCommand(command, "unlink");
}

TEST(UsbipWire, RepliesAreAsTheProtocolHasThem) {
    const auto expect = [](const Reply& expected, const std::string& name) {
        EXPECT_EQ(encodeReply(expected), golden(name)) << name;
        Reply reply;
        ASSERT_EQ(parseReply(golden(name), reply).status, Status::Complete) << name;
        EXPECT_EQ(reply.kind, expected.kind);
        EXPECT_EQ(reply.sequence, expected.sequence);
        EXPECT_EQ(reply.status, expected.status);
        EXPECT_EQ(reply.actual, expected.actual);
    };
    expect({Command::Kind::Submit, 9, TransferStatus::Ok, 4}, "reply-in");
    expect({Command::Kind::Submit, 9, TransferStatus::Stall, 0}, "reply-stalled");
    expect({Command::Kind::Unlink, 0x010204, TransferStatus::Reset, 0}, "reply-unlinked");
    const Bytes data{1, 2, 3, 4};
    Bytes whole = golden("reply-in");
    whole.insert(whole.end(), data.begin(), data.end());
    EXPECT_EQ(encodeReply({Command::Kind::Submit, 9, TransferStatus::Ok, 4}, data), whole);
}

TEST(UsbipWire, EveryFrontOfAMessageAsksForMoreThanItHas) {
    for (const fs::path& path : filesOf("golden")) {
        const DataFile file = load(path);
        std::size_t asked = 0;
        for (std::size_t size = 0; size < file.bytes.size(); ++size) {
            const Parse parse = parseAs(file.parser, ByteView(file.bytes).first(size));
            ASSERT_EQ(parse.status, Status::MoreNeeded) << path << " at " << size;
            ASSERT_GT(parse.bytes, size) << path;
            ASSERT_LE(parse.bytes, file.bytes.size()) << path;
            ASSERT_GE(parse.bytes, asked) << path << " at " << size;
            asked = parse.bytes;
        }
        const Parse whole = parseAs(file.parser, file.bytes);
        EXPECT_EQ(whole.status, Status::Complete) << path;
        EXPECT_EQ(whole.bytes, file.bytes.size()) << path;
        Bytes longer = file.bytes;
        longer.insert(longer.end(), 100, 0xA5);
        EXPECT_EQ(parseAs(file.parser, longer).bytes, file.bytes.size())
            << path << ": what follows is the next's";
    }
}

TEST(UsbipWire, DamagedMessagesAreRefusedAndSayWhy) {
    const auto files = filesOf("malformed");
    EXPECT_GE(files.size(), 10U);
    for (const fs::path& path : files) {
        const DataFile file = load(path);
        const Parse parse = parseAs(file.parser, file.bytes);
        EXPECT_EQ(parse.status, Status::Malformed) << path;
        EXPECT_EQ(parse.why, file.why) << path;
    }
}

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    template <class Number = std::uint32_t>
    Number number(std::uint32_t highest = 0xFFFFFFFF) {
        return static_cast<Number>(std::uniform_int_distribution<std::uint32_t>(0, highest)(engine_));
    }
    std::string text(std::uint32_t longest) {
        std::string text(number(longest), ' ');
        for (char& c : text)
            c = static_cast<char>('!' + number(90));
        return text;
    }
    Device device() {
        Device device;
        device.path = text(255);
        device.busId = text(kMaxBusIdLength);
        device.bus = number();
        device.number = number();
        device.speed = static_cast<Speed>(number());
        device.vendor = number<std::uint16_t>(0xFFFF);
        device.product = number<std::uint16_t>(0xFFFF);
        device.release = number<std::uint16_t>(0xFFFF);
        device.deviceClass = interfaceClass();
        device.configuration = number<std::uint8_t>(255);
        device.configurations = number<std::uint8_t>(255);
        return device;
    }
    InterfaceClass interfaceClass() {
        return {number<std::uint8_t>(255), number<std::uint8_t>(255), number<std::uint8_t>(255)};
    }

  private:
    std::mt19937 engine_;
};

TEST(UsbipWire, WhatIsWrittenReadsAsTheSame) {
    Random random(4);
    for (int round = 0; round < 300; ++round) {
        std::vector<Device> devices(random.number<std::size_t>(8));
        for (Device& device : devices) {
            device = random.device();
            device.interfaces.resize(random.number<std::size_t>(kMaxInterfaces));
            for (InterfaceClass& one : device.interfaces)
                one = random.interfaceClass();
        }
        OpStatus status = OpStatus::Error;
        std::vector<Device> read;
        ASSERT_EQ(parseDeviceList(encodeDeviceList(devices), status, read).status, Status::Complete);
        ASSERT_EQ(read, devices);

        const Device device = random.device();
        Device imported;
        ASSERT_EQ(parseImportReply(encodeImportReply(OpStatus::Ok, device), status, imported).status,
                  Status::Complete);
        ASSERT_EQ(imported, device);

        const Reply reply{random.number(1) ? Command::Kind::Submit : Command::Kind::Unlink, random.number(),
                          static_cast<TransferStatus>(random.number()), 0};
        Reply readReply;
        ASSERT_EQ(parseReply(encodeReply(reply), readReply).status, Status::Complete);
        ASSERT_EQ(readReply.sequence, reply.sequence);
        ASSERT_EQ(readReply.status, reply.status);
    }
}

TEST(UsbipWire, TextThatIsTooLongIsCutAndStillEnds) {
    Device device = dongle();
    device.path = std::string(1000, 'p');
    device.busId = std::string(100, 'b');
    OpStatus status = OpStatus::Error;
    Device read;
    ASSERT_EQ(parseImportReply(encodeImportReply(OpStatus::Ok, device), status, read).status,
              Status::Complete);
    EXPECT_EQ(read.path, std::string(255, 'p'));
    EXPECT_EQ(read.busId, std::string(kMaxBusIdLength, 'b'));
}

}  // namespace
}  // namespace kickstand::usbip
