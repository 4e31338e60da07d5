#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/smartdevice/catalogue.h"

namespace kickstand::smartdevice {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestFile = 1U << 20;
constexpr std::size_t kLongestName = 64;
constexpr char kFormat[] = "kickstand-smart-devices";
constexpr int kVersion = 1;

/// Reads a file piece by piece; the first thing that is wrong ends it, with its place.
class Reader {
  public:
    Reader(std::string source, Catalogue base) : source_(std::move(source)), catalogue_(std::move(base)) {}

    Result<Catalogue> read(std::string_view text) {
        if (text.size() > kLongestFile) return bad("it is longer than a megabyte");
        // Without exceptions: what cannot be parsed is "discarded".
        const Json file = Json::parse(text.begin(), text.end(), nullptr, false);
        if (file.is_discarded()) return bad("it is not JSON");
        if (!file.is_object() || file.value("format", Json()) != kFormat)
            return bad(std::string("it does not say \"format\": \"") + kFormat + "\"");
        if (file.value("version", Json()) != kVersion) return bad("its version is another one");
        const Json devices = file.value("devices", Json());
        if (!devices.is_array()) return bad("it has no list of devices");
        for (std::size_t i = 0; i < devices.size(); ++i) {
            where_ = "device " + std::to_string(i + 1);
            auto device = readDevice(devices[i]);
            if (!device) return fail(std::move(device.error()));
            if (const auto other = catalogue_.find(device->name); other && other->id != device->id)
                return bad("there is another device of that name");
            catalogue_.put(std::move(*device));
        }
        return finish();
    }

  private:
    tl::unexpected<Error> bad(const std::string& what) const {
        return fail(Errc::Malformed, source_, where_.empty() ? what : where_ + ": " + what);
    }

    /// The devices that are like another, once all are known.
    Result<Catalogue> finish() {
        for (const auto& [id, other] : like_) {
            const auto model = catalogue_.find(other);
            where_ = "device " + std::to_string(id);
            if (model == nullptr || model->reserved || model->id == id)
                return bad("there is no device named " + other + " to be like");
            DeviceSpec device = *catalogue_.find(id);
            device.parameters = model->parameters;
            catalogue_.put(std::move(device));
        }
        return std::move(catalogue_);
    }

    Result<DeviceSpec> readDevice(const Json& json) {
        if (!json.is_object()) return bad("it is not an object");
        DeviceSpec device;
        const Json id = json.value("id", Json());
        if (!id.is_number_unsigned() || id.get<std::uint64_t>() > std::numeric_limits<std::uint16_t>::max())
            return bad("its id is not a number from 0 to 65535");
        device.id = id.get<std::uint16_t>();
        if (auto name = readName(json); name)
            device.name = std::move(*name);
        else
            return fail(std::move(name.error()));
        where_ = device.name;
        if (auto known = onlyKnows(json, {"id", "name", "note", "reserved", "like", "parameters"}); !known)
            return fail(std::move(known.error()));
        device.note = textOf(json, "note");
        device.reserved = json.value("reserved", Json()) == true;
        const std::string like = textOf(json, "like");
        if (!like.empty()) like_.emplace_back(device.id, like);
        const Json parameters = json.value("parameters", Json());
        if ((device.reserved || !like.empty()) != parameters.is_null())
            return bad("it has parameters, or it is reserved, or like another: one of the three");
        return readParameters(parameters, std::move(device));
    }

    Result<DeviceSpec> readParameters(const Json& list, DeviceSpec device) {
        if (list.is_null()) return device;
        if (!list.is_array() || list.empty() || list.size() > wire::kMostParameters)
            return bad("its parameters are not a list of 1 to 16");
        for (const Json& one : list) {
            where_ = device.name + ", parameter " + std::to_string(device.parameters.size());
            auto parameter = readParameter(one);
            if (!parameter) return fail(std::move(parameter.error()));
            if (device.find(parameter->name) >= 0) return bad("there is another parameter of that name");
            device.parameters.push_back(std::move(*parameter));
        }
        return device;
    }

    Result<ParameterSpec> readParameter(const Json& json) const {
        if (!json.is_object()) return bad("it is not an object");
        ParameterSpec parameter;
        if (auto name = readName(json); name)
            parameter.name = std::move(*name);
        else
            return fail(std::move(name.error()));
        if (auto known = onlyKnows(
                json, {"name", "type", "access", "unit", "lowest", "highest", "moves", "stop", "note"});
            !known)
            return fail(std::move(known.error()));
        const auto type = wire::valueType(textOf(json, "type"));
        if (!type || *type == wire::ValueType::Raw) return bad("its type is none of the protocol's");
        parameter.type = *type;
        const auto access = accessOf(textOf(json, "access"));
        if (!access) return bad("its access is not read, write or read-write");
        parameter.access = *access;
        parameter.unit = textOf(json, "unit");
        parameter.note = textOf(json, "note");
        if (json.contains("stop")) {
            parameter.zeroOnStop = textOf(json, "stop") == "zero";
            if (!parameter.zeroOnStop || !parameter.writable())
                return bad("stop can only be \"zero\", of what can be written");
        }
        parameter.moves = parameter.zeroOnStop || json.value("moves", Json()) == true;
        return readRange(json, std::move(parameter));
    }

    Result<ParameterSpec> readRange(const Json& json, ParameterSpec parameter) const {
        for (const auto& [key, bound] :
             {std::pair{"lowest", &parameter.lowest}, {"highest", &parameter.highest}}) {
            if (!json.contains(key)) continue;
            const Json& value = json[key];
            if (!value.is_number() || !wire::fromNumber(parameter.type, value.get<double>()))
                return bad(std::string(key) + " is not a value of its type");
            *bound = value.get<double>();
        }
        if (parameter.lowest && parameter.highest && *parameter.lowest > *parameter.highest)
            return bad("lowest is above highest");
        return parameter;
    }

    Result<std::string> readName(const Json& json) const {
        std::string name = textOf(json, "name");
        const bool right =
            !name.empty() && name.size() <= kLongestName &&
            std::ranges::all_of(name, [](unsigned char c) { return c > ' ' && c != '=' && c != 0x7F; });
        if (!right) return bad("it has no name of 1 to 64 characters without spaces");
        return name;
    }

    static std::string textOf(const Json& json, const char* key) {
        const Json value = json.value(key, Json());
        return value.is_string() ? value.get<std::string>() : std::string();
    }

    static std::optional<Access> accessOf(std::string_view text) {
        if (text == "read") return Access::Read;
        if (text == "write") return Access::Write;
        if (text == "read-write") return Access::ReadWrite;
        return std::nullopt;
    }

    /// A key that nobody reads is a slip of the pen.
    Result<void> onlyKnows(const Json& json, std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, value] : json.items()) {
            if (std::ranges::find(keys, key) == keys.end()) return bad("\"" + key + "\" means nothing here");
        }
        return {};
    }

    const std::string source_;
    Catalogue catalogue_;
    std::string where_;
    std::vector<std::pair<std::uint16_t, std::string>> like_;
};

}  // namespace

Result<Catalogue> readCatalogue(std::string_view text, const std::string& source, Catalogue base) {
    return Reader(source, std::move(base)).read(text);
}

}  // namespace kickstand::smartdevice
