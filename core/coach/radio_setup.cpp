#include "core/coach/radio_setup.h"

#include <algorithm>
#include <utility>

namespace kickstand::coach {
namespace {

constexpr AtName kMy{'M', 'Y'};
constexpr AtName kChannel{'C', 'H'};
constexpr AtName kPan{'I', 'D'};
constexpr AtName kMode{'A', 'P'};
constexpr AtName kBaud{'B', 'D'};
constexpr AtName kName{'N', 'I'};
constexpr AtName kFirmware{'V', 'R'};
constexpr AtName kHardware{'H', 'V'};
constexpr AtName kSerialHigh{'S', 'H'};
constexpr AtName kSerialLow{'S', 'L'};
constexpr AtName kWrite{'W', 'R'};
constexpr AtName kLeave{'C', 'N'};

constexpr std::array kQuestions{kMy,   kChannel,  kPan,      kMode,       kBaud,
                                kName, kFirmware, kHardware, kSerialHigh, kSerialLow};

/// A number of as many bytes as came, eight at most.
std::uint64_t numberOf(const std::vector<std::uint8_t>& bytes) {
    std::uint64_t number = 0;
    for (const std::uint8_t byte : bytes)
        number = number << 8 | byte;
    return number;
}

std::vector<std::uint8_t> bytesOf(std::uint32_t number, std::size_t count) {
    std::vector<std::uint8_t> bytes(4);
    storeBe32(bytes, 0, number);
    return {bytes.end() - static_cast<std::ptrdiff_t>(count), bytes.end()};
}

}  // namespace

RadioSetup::RadioSetup(Scheduler& scheduler, ByteLink& link, RadioLine& line)
    : scheduler_(scheduler), link_(link), line_(line), client_(scheduler, line) {}

void RadioSetup::begin(Done done) {
    cancel();
    done_ = std::move(done);
    found_ = {};
    places_.clear();
    steps_.clear();
    wanted_.reset();
    written_ = false;
}

void RadioSetup::cancel() {
    ++job_;
    client_.cancel();
    done_ = {};
}

void RadioSetup::finish(Result<FoundRadio> result) {
    auto done = std::exchange(done_, {});
    ++job_;
    client_.cancel();
    if (done) done(std::move(result));
}

void RadioSetup::ask(Baud baud, Done done) {
    begin(std::move(done));
    places_.push_back({baud, true});
    tryNext();
}

void RadioSetup::find(Baud baud, Done done) {
    begin(std::move(done));
    std::vector<Baud> bauds{baud, 9600, 115200, 57600, 38400, 19200, kThunderbotsBaud, 4800, 2400, 1200};
    bauds.erase(std::remove(bauds.begin() + 1, bauds.end(), baud), bauds.end());
    for (const bool frames : {true, false}) {
        for (const Baud one : bauds)
            places_.push_back({one, frames});
    }
    std::reverse(places_.begin(), places_.end());
    tryNext();
}

void RadioSetup::setBaud(Baud baud, std::function<void()> then) {
    baud_ = baud;
    link_.setBaud(baud, [this, job = job_, then = std::move(then)](const Result<void>& set) {
        if (job != job_) return;
        if (set) return then();
        if (set.error().code == Errc::NotConnected || set.error().code == Errc::Cancelled)
            return finish(fail(set.error()));
        // A speed that this port does not have is one at which no module can be found.
        tryNext();
    });
}

void RadioSetup::tryNext() {
    if (places_.empty()) {
        finish(fail(Errc::TimedOut, "radio"));
        return;
    }
    const Place place = places_.back();
    places_.pop_back();
    setBaud(place.baud, [this, frames = place.frames] { frames ? tryFrames() : tryText(); });
}

void RadioSetup::tryFrames() {
    line_.setMode(ModuleMode::Api);
    // The question and its answer read the same in both modes.
    client_.ask(kMode, {}, [this](const Result<std::vector<std::uint8_t>>& value) {
        if (!value) return tryNext();
        line_.setMode(numberOf(*value) == 2 ? ModuleMode::ApiEscaped : ModuleMode::Api);
        read();
    });
}

void RadioSetup::tryText() {
    line_.setMode(ModuleMode::Transparent);
    client_.enterCommandMode([this](const Result<std::vector<std::uint8_t>>& entered) {
        if (!entered) return tryNext();
        read();
    });
}

void RadioSetup::read() {
    found_ = {};
    steps_.clear();
    for (const AtName name : kQuestions)
        steps_.push_back({name});
    std::reverse(steps_.begin(), steps_.end());
    readNext();
}

void RadioSetup::readNext() {
    if (steps_.empty()) {
        leave([this] { verify(); });
        return;
    }
    const AtName name = steps_.back().name;
    steps_.pop_back();
    client_.ask(name, {}, [this, name](const Result<std::vector<std::uint8_t>>& value) {
        // A module that was found and falls silent is asked anew from the next place on.
        if (!value && value.error().code == Errc::TimedOut && !places_.empty()) return tryNext();
        if (!value) return finish(fail(value.error()));
        take(name, *value);
        readNext();
    });
}

void RadioSetup::take(AtName name, const std::vector<std::uint8_t>& value) {
    const std::uint64_t number = numberOf(value);
    RadioSettings& settings = found_.settings;
    if (name == kMy) settings.address = static_cast<std::uint16_t>(number);
    if (name == kChannel) settings.channel = static_cast<std::uint8_t>(number);
    if (name == kPan) settings.pan = static_cast<std::uint16_t>(number);
    if (name == kMode) settings.mode = static_cast<ModuleMode>(std::min<std::uint64_t>(number, 2));
    if (name == kBaud) settings.baud = baudOf(static_cast<std::uint32_t>(number));
    if (name == kName) {
        // A module without a name says a space.
        settings.name.assign(value.begin(), value.end());
        if (settings.name == " ") settings.name.clear();
    }
    if (name == kFirmware) found_.identity.firmware = static_cast<std::uint16_t>(number);
    if (name == kHardware) found_.identity.hardware = static_cast<std::uint16_t>(number);
    if (name == kSerialHigh) found_.identity.serial |= number << 32;
    if (name == kSerialLow) found_.identity.serial |= number & 0xFFFFFFFF;
}

/// Ends the command mode, where the module is in it.
void RadioSetup::leave(std::function<void()> then) {
    if (line_.mode() != ModuleMode::Transparent) return then();
    client_.ask(kLeave, {}, [then = std::move(then)](const Result<std::vector<std::uint8_t>>&) { then(); });
}

void RadioSetup::verify() {
    if (wanted_ && !written_) {
        // It was found again after its speed or mode had changed: what is left is to make that last.
        written_ = true;
        steps_ = {{kWrite, {}}};
        client_.enterCommandMode([this](const Result<std::vector<std::uint8_t>>& entered) {
            if (!entered) return finish(fail(entered.error()));
            setNext();
        });
        return;
    }
    if (wanted_ && found_.settings != *wanted_) {
        finish(fail(Errc::RadioDiffers, "radio"));
        return;
    }
    finish(found_);
}

void RadioSetup::planChanges(const RadioSettings& present) {
    const RadioSettings& wanted = *wanted_;
    steps_.clear();
    if (wanted.address != present.address) steps_.push_back({kMy, bytesOf(wanted.address, 2)});
    if (wanted.channel != present.channel) steps_.push_back({kChannel, bytesOf(wanted.channel, 1)});
    if (wanted.pan != present.pan) steps_.push_back({kPan, bytesOf(wanted.pan, 2)});
    if (wanted.name != present.name) {
        // No name is written as a space: nothing at all would be a question.
        const std::string name = wanted.name.empty() ? " " : wanted.name;
        steps_.push_back({kName, {name.begin(), name.end()}});
    }
    if (wanted.mode != present.mode)
        steps_.push_back({kMode, bytesOf(static_cast<std::uint32_t>(wanted.mode), 1)});
    if (wanted.baud != present.baud) steps_.push_back({kBaud, bytesOf(baudCode(wanted.baud), 4)});
    std::reverse(steps_.begin(), steps_.end());
}

void RadioSetup::apply(const RadioSettings& present, const RadioSettings& wanted, Done done) {
    begin(std::move(done));
    if (auto right = checkSettings(wanted); !right) return finish(fail(right.error()));
    wanted_ = wanted;
    planChanges(present);
    tryWantedBaud([this] {
        client_.enterCommandMode([this](const Result<std::vector<std::uint8_t>>& entered) {
            if (!entered) return finish(fail(entered.error()));
            setNext();
        });
    });
}

/// A module at a speed that the port does not have would be lost: the port is asked before the module is.
void RadioSetup::tryWantedBaud(std::function<void()> then) {
    const Baud present = baud_;
    const Baud wanted = wanted_->baud;
    if (wanted == present) return then();
    link_.setBaud(wanted, [this, job = job_, present, wanted, then = std::move(then)](Result<void> set) {
        if (job != job_) return;
        if (set) return setBaud(present, then);
        if (set.error().code != Errc::NotConnected && set.error().code != Errc::Cancelled)
            set = fail(Errc::Unsupported, std::to_string(wanted) + " baud");
        finish(fail(set.error()));
    });
}

void RadioSetup::setNext() {
    if (steps_.empty()) {
        // In its command mode a module takes all of it when it leaves.
        leave([this] {
            const Baud baud = wanted_->baud;
            const bool frames = wanted_->mode != ModuleMode::Transparent;
            places_ = {{baud, !frames}, {baud, frames}};
            tryNext();
        });
        return;
    }
    const Step step = steps_.back();
    steps_.pop_back();
    client_.ask(step.name, step.value, [this, step](const Result<std::vector<std::uint8_t>>& value) {
        if (!value) return finish(fail(value.error()));
        afterSetting(step.name);
    });
}

/// In frames, mode and speed count at once.
void RadioSetup::afterSetting(AtName name) {
    const bool frames = line_.mode() != ModuleMode::Transparent;
    if (frames && name == kMode && wanted_->mode != line_.mode()) {
        line_.setMode(wanted_->mode);
        if (wanted_->mode == ModuleMode::Transparent) {
            client_.enterCommandMode([this](const Result<std::vector<std::uint8_t>>& entered) {
                if (!entered) return finish(fail(entered.error()));
                setNext();
            });
            return;
        }
    }
    if (frames && name == kBaud && line_.mode() != ModuleMode::Transparent)
        return setBaud(wanted_->baud, [this] { setNext(); });
    setNext();
}

}  // namespace kickstand::coach
