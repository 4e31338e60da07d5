#include "app/kickstandctl/codecs.h"

#include "core/coach/wire/named_frame.h"
#include "core/motionplan/wire/named.h"
#include "core/smartdevice/wire/named_frame.h"
#include "core/thunderbots/wire/fields.h"

namespace kickstand::ctl {
namespace {

std::vector<CodecMessage> thunderbotsMessages() {
    namespace wire = thunderbots::wire;
    std::vector<CodecMessage> messages;
    for (const wire::MessageSpec& message : wire::messages()) {
        CodecMessage listed{message.name, {}};
        for (const wire::FieldSpec& field : message.fields) {
            // What a person neither gives nor needs to read.
            const bool fixed =
                field.kind == wire::FieldKind::Reserved || field.kind == wire::FieldKind::Opcode;
            if (!fixed) listed.fields.emplace_back(field.name);
        }
        messages.push_back(std::move(listed));
    }
    return messages;
}

std::vector<CodecMessage> motionplanMessages() {
    std::vector<CodecMessage> messages;
    for (const motionplan::wire::NamedSpec& telegram : motionplan::wire::namedTelegrams())
        messages.push_back({telegram.name, telegram.fields});
    return messages;
}

Result<std::vector<CodecField>> decodeMotionplan(std::string_view name, ByteView bytes) {
    auto fields = motionplan::wire::decodeNamed(name, bytes);
    if (!fields) return fail(std::move(fields.error()));
    std::vector<CodecField> decoded;
    for (motionplan::wire::NamedField& field : *fields)
        decoded.push_back({std::move(field.name), field.value, field.isBytes, std::move(field.bytes),
                           field.physical, std::move(field.unit), std::move(field.label),
                           std::move(field.description)});
    return decoded;
}

std::vector<CodecMessage> smartDeviceMessages() {
    namespace wire = smartdevice::wire;
    const std::vector<std::string> fields = wire::namedFrameFields();
    return {{std::string(wire::kFrameName), fields}, {std::string(wire::kHibikeFrameName), fields}};
}

Result<std::vector<CodecField>> decodeSmartDevice(std::string_view name, ByteView bytes) {
    auto fields = smartdevice::wire::decodeNamedFrame(name, bytes);
    if (!fields) return fail(std::move(fields.error()));
    std::vector<CodecField> decoded;
    for (smartdevice::wire::NamedField& field : *fields)
        decoded.push_back({std::move(field.name), field.value, field.isBytes, std::move(field.bytes),
                           field.physical, std::move(field.unit), std::move(field.label),
                           std::move(field.description)});
    return decoded;
}

std::vector<CodecMessage> coachMessages() {
    const std::vector<std::string> fields = coach::wire::namedFrameFields();
    return {{std::string(coach::wire::kFrameName), fields},
            {std::string(coach::wire::kEscapedFrameName), fields}};
}

Result<std::vector<CodecField>> decodeCoach(std::string_view name, ByteView bytes) {
    auto fields = coach::wire::decodeNamedFrame(name, bytes);
    if (!fields) return fail(std::move(fields.error()));
    std::vector<CodecField> decoded;
    for (coach::wire::NamedField& field : *fields)
        decoded.push_back({std::move(field.name),
                           field.value,
                           false,
                           {},
                           field.physical,
                           std::move(field.unit),
                           std::move(field.label),
                           std::move(field.description)});
    return decoded;
}

Result<std::vector<std::uint8_t>> encodeCoach(std::string_view name, std::span<const CodecText> fields) {
    return coach::wire::encodeNamedFrame(name, {fields.begin(), fields.end()});
}

constexpr Codec kCodecs[] = {
    {"thunderbots", thunderbotsMessages, thunderbots::wire::decodeMessage, thunderbots::wire::encodeMessage},
    {"smartdevice", smartDeviceMessages, decodeSmartDevice, smartdevice::wire::encodeNamedFrame},
    {"motionplan", motionplanMessages, decodeMotionplan, motionplan::wire::encodeNamed},
    {"coach", coachMessages, decodeCoach, encodeCoach},
};

}  // namespace

std::span<const Codec> codecs() {
    return kCodecs;
}

const Codec& codecFor(std::string_view message) {
    for (const Codec& codec : kCodecs) {
        if (message.substr(0, message.find('.')) == codec.system) return codec;
    }
    return kCodecs[0];
}

}  // namespace kickstand::ctl
