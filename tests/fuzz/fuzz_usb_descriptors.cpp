#include "core/link/usbip/usb_descriptor_reader.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    if (readDeviceDescriptor(input)) fuzz::require(size >= kDeviceDescriptorBytes, "a device is read whole");
    const auto length = readConfigurationLength(input);
    if (const auto read = readConfigurationDescriptor(input)) {
        fuzz::require(length && *length <= size, "a configuration is read whole");
        fuzz::require(read->endpoints.size() <= 30, "a device has at most 30 endpoints");
        for (const UsbEndpointInfo& endpoint : read->endpoints)
            fuzz::require((endpoint.address & 0x0F) != 0, "endpoint 0 is nobody's own");
    }
    const std::string text = readStringDescriptor(input);
    fuzz::require(text.size() <= size * 2, "a text is no longer than its bytes make it");
    for (const char c : text)
        fuzz::require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F, "a text has no control characters");
    static_cast<void>(readFirstLanguage(input));
    return 0;
}
