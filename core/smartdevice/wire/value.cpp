#include "core/smartdevice/wire/value.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/base/hex.h"

namespace kickstand::smartdevice::wire {
namespace {

struct TypeFacts {
    const char* name;
    std::size_t width;
};
constexpr std::array<TypeFacts, kValueTypes> kTypes{{{"bool", 1},
                                                     {"uint8", 1},
                                                     {"int8", 1},
                                                     {"uint16", 2},
                                                     {"int16", 2},
                                                     {"uint32", 4},
                                                     {"int32", 4},
                                                     {"uint64", 8},
                                                     {"int64", 8},
                                                     {"float", 4},
                                                     {"double", 8},
                                                     {"raw", 0}}};

constexpr std::size_t indexOf(ValueType type) {
    return static_cast<std::size_t>(type);
}

std::uint64_t load(ByteView bytes) noexcept {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        number |= std::uint64_t{bytes[i]} << 8 * i;
    return number;
}

RawValue store(std::uint64_t number, std::size_t width) noexcept {
    RawValue bytes;
    for (std::size_t i = 0; i < width; ++i)
        bytes.append(static_cast<std::uint8_t>(number >> 8 * i));
    return bytes;
}

template <class T>
std::optional<Value> wholeFrom(double number) noexcept {
    // The bounds as doubles: the upper one is exclusive, because 2^63 - 1 is none.
    constexpr double kLowest = static_cast<double>(std::numeric_limits<T>::min());
    const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
    if (!(number >= kLowest && number < beyond) || number != std::floor(number)) return std::nullopt;
    return Value(static_cast<T>(number));
}

std::optional<Value> floatFrom(double number) noexcept {
    if (!std::isfinite(number) || std::abs(number) > std::numeric_limits<float>::max()) return std::nullopt;
    return Value(static_cast<float>(number));
}

tl::unexpected<Error> noValue(const std::string& subject, std::string_view text) {
    return fail(Errc::BadArgument, subject, "“" + std::string(text) + "”");
}

/// "-12", and nothing else.
bool isNegative(std::string_view text) {
    return text.size() > 1 && text.starts_with('-') &&
           std::all_of(text.begin() + 1, text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

template <class T>
Result<Value> readWhole(std::string_view text, const std::string& subject) {
    std::string_view digits = text;
    int base = 10;
    if (digits.starts_with("0x") || digits.starts_with("0X")) {
        digits.remove_prefix(2);
        base = 16;
        if (digits.starts_with('-')) return noValue(subject, text);
    }
    T number{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, base);
    const bool tooLow = std::is_unsigned_v<T> && isNegative(text);
    if (error == std::errc::result_out_of_range || tooLow) {
        Error out;
        out.code = Errc::OutOfRange;
        out.subject = subject;
        out.detail = std::string(text);
        out.lowest = static_cast<std::int64_t>(std::numeric_limits<T>::min());
        if (std::numeric_limits<T>::digits < 64)
            out.highest = static_cast<std::int64_t>(std::numeric_limits<T>::max());
        return fail(std::move(out));
    }
    if (error != std::errc() || end != digits.data() + digits.size() || digits.empty())
        return noValue(subject, text);
    return Value(number);
}

template <class T>
Result<Value> readFraction(std::string_view text, const std::string& subject) {
    T number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
        return noValue(subject, text);
    return Value(number);
}

Result<Value> readBool(std::string_view text, const std::string& subject) {
    for (const std::string_view yes : {"true", "on", "1"}) {
        if (text == yes) return Value(true);
    }
    for (const std::string_view no : {"false", "off", "0"}) {
        if (text == no) return Value(false);
    }
    return noValue(subject, text);
}

Result<Value> readRaw(std::string_view text, const std::string& subject) {
    const auto bytes = parseHex(text);
    RawValue raw;
    if (!bytes || bytes->empty() || !raw.append(*bytes)) return noValue(subject, text);
    return Value(raw);
}

template <class T>
std::string numberText(T number) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
}

}  // namespace

const char* name(ValueType type) noexcept {
    return kTypes.at(indexOf(type)).name;
}

std::optional<ValueType> valueType(std::string_view name) noexcept {
    if (name.ends_with("_t")) name.remove_suffix(2);
    for (std::size_t i = 0; i < kTypes.size(); ++i) {
        if (name == kTypes.at(i).name) return static_cast<ValueType>(i);
    }
    return std::nullopt;
}

std::size_t widthOf(ValueType type) noexcept {
    return kTypes.at(indexOf(type)).width;
}

bool isInteger(ValueType type) noexcept {
    return type >= ValueType::Uint8 && type <= ValueType::Int64;
}

std::optional<Value> readValue(ValueType type, ByteView bytes) noexcept {
    const bool fits = type == ValueType::Raw ? !bytes.empty() && bytes.size() <= kWidestValue
                                             : bytes.size() == widthOf(type);
    if (!fits) return std::nullopt;
    const std::uint64_t number = load(bytes);
    switch (type) {
        case ValueType::Bool:
            return Value(number != 0);
        case ValueType::Uint8:
            return Value(static_cast<std::uint8_t>(number));
        case ValueType::Int8:
            return Value(static_cast<std::int8_t>(number));
        case ValueType::Uint16:
            return Value(static_cast<std::uint16_t>(number));
        case ValueType::Int16:
            return Value(static_cast<std::int16_t>(number));
        case ValueType::Uint32:
            return Value(static_cast<std::uint32_t>(number));
        case ValueType::Int32:
            return Value(static_cast<std::int32_t>(number));
        case ValueType::Uint64:
            return Value(number);
        case ValueType::Int64:
            return Value(static_cast<std::int64_t>(number));
        case ValueType::Float:
            return Value(std::bit_cast<float>(static_cast<std::uint32_t>(number)));
        case ValueType::Double:
            return Value(std::bit_cast<double>(number));
        case ValueType::Raw:
            break;
    }
    RawValue raw;
    raw.append(bytes);
    return Value(raw);
}

RawValue bytesOf(const Value& value) {
    return std::visit(
        [](const auto& held) {
            using T = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<T, RawValue>)
                return held;
            else if constexpr (std::is_same_v<T, float>)
                return store(std::bit_cast<std::uint32_t>(held), sizeof(T));
            else if constexpr (std::is_same_v<T, double>)
                return store(std::bit_cast<std::uint64_t>(held), sizeof(T));
            else
                return store(static_cast<std::uint64_t>(held), sizeof(T));
        },
        value);
}

std::optional<double> toNumber(const Value& value) {
    return std::visit(
        [](const auto& held) -> std::optional<double> {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, RawValue>)
                return std::nullopt;
            else
                return static_cast<double>(held);
        },
        value);
}

std::optional<Value> fromNumber(ValueType type, double number) noexcept {
    switch (type) {
        case ValueType::Bool:
            if (number != 0 && number != 1) return std::nullopt;
            return Value(number == 1);
        case ValueType::Uint8:
            return wholeFrom<std::uint8_t>(number);
        case ValueType::Int8:
            return wholeFrom<std::int8_t>(number);
        case ValueType::Uint16:
            return wholeFrom<std::uint16_t>(number);
        case ValueType::Int16:
            return wholeFrom<std::int16_t>(number);
        case ValueType::Uint32:
            return wholeFrom<std::uint32_t>(number);
        case ValueType::Int32:
            return wholeFrom<std::int32_t>(number);
        case ValueType::Uint64:
            return wholeFrom<std::uint64_t>(number);
        case ValueType::Int64:
            return wholeFrom<std::int64_t>(number);
        case ValueType::Float:
            return floatFrom(number);
        case ValueType::Double:
            if (!std::isfinite(number)) return std::nullopt;
            return Value(number);
        case ValueType::Raw:
            break;
    }
    return std::nullopt;
}

std::string toText(const Value& value) {
    return std::visit(
        [](const auto& held) -> std::string {
            using T = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<T, bool>)
                return held ? "true" : "false";
            else if constexpr (std::is_same_v<T, RawValue>)
                return toHex(held.view());
            else
                return numberText(held);
        },
        value);
}

Result<Value> fromText(ValueType type, std::string_view text, const std::string& subject) {
    switch (type) {
        case ValueType::Bool:
            return readBool(text, subject);
        case ValueType::Uint8:
            return readWhole<std::uint8_t>(text, subject);
        case ValueType::Int8:
            return readWhole<std::int8_t>(text, subject);
        case ValueType::Uint16:
            return readWhole<std::uint16_t>(text, subject);
        case ValueType::Int16:
            return readWhole<std::int16_t>(text, subject);
        case ValueType::Uint32:
            return readWhole<std::uint32_t>(text, subject);
        case ValueType::Int32:
            return readWhole<std::int32_t>(text, subject);
        case ValueType::Uint64:
            return readWhole<std::uint64_t>(text, subject);
        case ValueType::Int64:
            return readWhole<std::int64_t>(text, subject);
        case ValueType::Float:
            return readFraction<float>(text, subject);
        case ValueType::Double:
            return readFraction<double>(text, subject);
        case ValueType::Raw:
            break;
    }
    return readRaw(text, subject);
}

}  // namespace kickstand::smartdevice::wire
