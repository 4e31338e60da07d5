#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/thunderbots/wire/generic.h"

namespace kickstand::ctl {

/// One field of a decoded message, whichever system it is of.
using CodecField = thunderbots::wire::DecodedField;
/// A field's name and its value as text.
using CodecText = std::pair<std::string, std::string>;

/// A message that a person can name, with those fields that a person gives or reads.
struct CodecMessage {
    std::string name;
    std::vector<std::string> fields;
};

/// The messages of one system by their names, all of which begin with the system's.
struct Codec {
    std::string_view system;  ///< "thunderbots".
    std::vector<CodecMessage> (*messages)();
    Result<std::vector<CodecField>> (*decode)(std::string_view name, ByteView bytes);
    Result<std::vector<std::uint8_t>> (*encode)(std::string_view name, std::span<const CodecText> fields);
};

/// Every system's, in the order in which they are listed.
std::span<const Codec> codecs();
/// That of a message's name; the first one where no system has such a name, for its error.
const Codec& codecFor(std::string_view message);

}  // namespace kickstand::ctl
