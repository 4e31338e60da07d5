// The messages in tests/data/wire, one a file: README.md there says what the lines mean and where each comes
// from.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/thunderbots/wire/generic.h"
#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

struct DataFile {
    std::string message;
    Bytes bytes;
    std::vector<FieldText> fields;
    std::string fault;  ///< "kind field", where the bytes are malformed.
};

DataFile readDataFile(const std::filesystem::path& path) {
    DataFile file;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        std::istringstream words(line);
        std::string key;
        words >> key >> std::ws;
        std::string rest;
        std::getline(words, rest);
        if (key == "message") {
            file.message = rest;
        } else if (key == "bytes") {
            file.bytes = hex(rest);
        } else if (key == "fault") {
            file.fault = rest;
        } else if (key == "field") {
            const std::size_t space = rest.find(' ');
            file.fields.emplace_back(rest.substr(0, space), rest.substr(space + 1));
        } else {
            ADD_FAILURE() << path << ": " << line;
        }
    }
    return file;
}

void expectMalformed(const DataFile& file) {
    const auto decoded = decodeMessage(file.message, file.bytes);
    ASSERT_FALSE(decoded.has_value());
    const std::string kind = decoded.error().detail.substr(0, decoded.error().detail.find(','));
    const std::string field = decoded.error().subject.substr(decoded.error().subject.rfind(' ') + 1);
    EXPECT_EQ(kind + ' ' + field, file.fault);
}

void expectGolden(const DataFile& file) {
    const auto encoded = encodeMessage(file.message, file.fields);
    ASSERT_TRUE(encoded.has_value()) << encoded.error().subject << ' ' << encoded.error().detail;
    EXPECT_EQ(toHex(*encoded), toHex(file.bytes));
    const auto decoded = decodeMessage(file.message, file.bytes);
    ASSERT_TRUE(decoded.has_value()) << decoded.error().subject;
    std::vector<FieldText> again;
    for (const DecodedField& field : *decoded) {
        again.emplace_back(field.name, field.isBytes ? toHex(field.bytes) : std::to_string(field.value));
    }
    EXPECT_EQ(encodeMessage(file.message, again).value(), file.bytes);
}

TEST(DataFiles, EachDecodesAndEncodesOrFailsAsItSays) {
    int golden = 0;
    int malformed = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(KICKSTAND_WIRE_DATA)) {
        if (entry.path().extension() != ".wire") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const DataFile file = readDataFile(entry.path());
        if (file.fault.empty()) {
            expectGolden(file);
            ++golden;
        } else {
            expectMalformed(file);
            ++malformed;
        }
    }
    EXPECT_GE(golden, 20);
    EXPECT_GE(malformed, 20);
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
