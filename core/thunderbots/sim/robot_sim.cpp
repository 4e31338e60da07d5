#include "core/thunderbots/sim/robot_sim.h"

#include <algorithm>
#include <chrono>

#include "core/thunderbots/wire/indicator.h"
#include "core/thunderbots/wire/kick_timing.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kDriveTimeout = seconds(1);
constexpr Duration kBootTime = seconds(3);
constexpr Duration kCopyTime = seconds(5);
// The first readings come this long after the robot is up.
constexpr Duration kFirstReadings = milliseconds(100);
// Motors and charger load the battery, which is taken as constant over one step.
constexpr Duration kStep = milliseconds(25);
// By then every quick curve has reached its end.
constexpr Duration kSettled = seconds(10);
constexpr std::size_t kMaxOutgoing = 32;
constexpr std::uint8_t kFactoryDribblerDuty = 180;
constexpr std::size_t kFactoryBitstreamPages = 64;

wire::OperationalParameters factoryParameters(const RobotSettings& settings) {
    wire::OperationalParameters parameters;
    parameters.flashContents = static_cast<std::uint8_t>(wire::FlashContents::FpgaBitstream);
    parameters.channel0 = settings.channels.channel0;
    parameters.channel1 = settings.channels.channel1;
    parameters.robotNumber = settings.number;
    parameters.dribblerDuty = kFactoryDribblerDuty;
    parameters.tail.append(0);
    return parameters;
}

/// Stands for a bitstream: what matters is that the flash is not blank.
void programFactoryBitstream(FlashChip& flash) {
    FlashChip::Page page{};
    for (std::size_t number = 0; number < kFactoryBitstreamPages; ++number) {
        for (std::size_t i = 0; i < page.size(); ++i)
            page[i] = static_cast<std::uint8_t>(i * 7 + number * 13);
        flash.program(number, page);
    }
}

}  // namespace

RobotSim::RobotSim(Scheduler& scheduler, const RobotSettings& settings)
    : scheduler_(scheduler),
      body_(settings.battery_V),
      controller_(factoryParameters(settings)),
      firmware_(scheduler, flash_, controller_,
                [this](const wire::MessagePayload& response, bool rebootAfterwards) {
                    send(wire::Pipe::FirmwareResponse, response, rebootAfterwards);
                }),
      bootTimer_(scheduler),
      lockOutTimer_(scheduler),
      noise_(settings.seed),
      noisy_(settings.noise),
      time_(scheduler.now()),
      detailEnd_(time_),
      validFrom_(time_) {
    programFactoryBitstream(flash_);
    configure();
}

// ---- Time ----

void RobotSim::advance() {
    const TimePoint now = scheduler_.now();
    if (driveFresh_ && now >= driveTime_ + kDriveTimeout) {
        passTo(driveTime_ + kDriveTimeout);
        driveFresh_ = false;
        ++driveTimeouts_;
        act(wire::brakedBlock());
    }
    passTo(now);
}

void RobotSim::passTo(TimePoint until) {
    while (time_ < until) {
        const Duration rest = until - time_;
        const Duration span = time_ < detailEnd_ ? std::min(rest, kStep) : rest;
        body_.step(span, inputs());
        time_ += span;
        const bool powered = power_ != RobotPower::Off && power_ != RobotPower::LockedOut;
        if (powered && body_.battery.lockedOut()) powerDown(RobotPower::LockedOut);
    }
}

BodyInputs RobotSim::inputs() const {
    if (!up() || !fpga_) return {};
    return {.run = acting_.run,
            .charge = acting_.charge,
            .dribble = acting_.dribble,
            .wheels = acting_.wheels,
            .dribblerDuty = controller_.shadow().dribblerDuty};
}

void RobotSim::act(const wire::DriveBlock& block) {
    acting_ = block;
    detailEnd_ = time_ + kSettled;
}

// ---- What comes from the host ----

void RobotSim::takeDrive(ByteView block) {
    const TimePoint now = scheduler_.now();
    ++driveBlocks_;
    const bool repeated =
        driveFresh_ && now < driveTime_ + kDriveTimeout && std::ranges::equal(block, driveBytes_);
    if (repeated) {
        driveTime_ = now;
        return;
    }
    advance();
    if (!up()) return;
    const auto decoded = wire::decodeDrive(block);
    if (!decoded) {
        ++malformed_;
        return;
    }
    if (*decoded != lastDrive_) ++driveChanges_;
    std::ranges::copy(block, driveBytes_.begin());
    lastDrive_ = *decoded;
    driveTime_ = now;
    driveFresh_ = true;
    act(*decoded);
    considerAutokick();
}

void RobotSim::refreshDrive() {
    advance();
    if (driveFresh_) driveTime_ = scheduler_.now();
}

void RobotSim::takeMessage(wire::Pipe pipe, ByteView payload) {
    advance();
    if (!up()) return;
    switch (pipe) {
        case wire::Pipe::Kick:
            return takeKick(payload);
        case wire::Pipe::FirmwareRequest:
            return firmware_.handle(payload);
        case wire::Pipe::TestMode:
            return takeTestMode(payload);
        default:
            ++malformed_;
    }
}

void RobotSim::takeKick(ByteView payload) {
    if (const auto times = wire::decodeKick(payload)) {
        kick(*times, false);
    } else {
        ++malformed_;
    }
}

void RobotSim::kick(const wire::KickTimes& times, bool automatic) {
    if (!fpga_) return;
    const auto pulses = wire::pulsesOf(times);
    Duration on{};
    Duration busy{};
    for (const wire::Pulse& pulse : pulses) {
        on += std::chrono::microseconds(pulse.width_us);
        busy = std::max<Duration>(busy, std::chrono::microseconds(pulse.start_us + pulse.width_us));
    }
    const double before_V = body_.capacitor.volts();
    body_.capacitor.discharge(on, busy);
    detailEnd_ = time_ + kSettled;
    ++kicks_;
    if (automatic) ++automaticKicks_;
    if (lastKicks_.size() == kKickRecords) lastKicks_.pop_front();
    lastKicks_.push_back({scheduler_.now(), pulses, before_V, body_.capacitor.volts(), automatic});
}

void RobotSim::considerAutokick() {
    const TimePoint now = scheduler_.now();
    const bool armed = acting_.autokickArmed && !wire::isNoAutokick(acting_.autokick);
    if (!up() || !fpga_ || !armed || !beam_.ball()) return;
    if (beam_.lockedOut(now)) {
        if (!beam_.lockOutEnd()) return;
        lockOutTimer_.startAt(*beam_.lockOutEnd(), [this] {
            advance();
            considerAutokick();
        });
        return;
    }
    kick(acting_.autokick, true);
    beam_.lockOut();
    if (const auto indicator = wire::encodeIndicator(wire::AutokickFired{}))
        send(wire::Pipe::Indicator, *indicator);
}

void RobotSim::takeTestMode(ByteView payload) {
    if (const auto mode = wire::decodeTestMode(payload)) {
        testMode_ = *mode;
        ++testModeMessages_;
    } else {
        ++malformed_;
    }
}

wire::TestMode RobotSim::shownTestMode() const {
    if (acting_.testClass == 0) return testMode_;
    const auto testClass = wire::testClassFromNumber(acting_.testClass);
    return {.testClass = testClass.value_or(wire::TestClass::None), .target = acting_.testTarget};
}

// ---- What goes to the host ----

std::optional<RobotSim::FeedbackBytes> RobotSim::feedback() {
    advance();
    if (!up()) return std::nullopt;
    const auto bytes = wire::encodeFeedback(measure());
    if (!bytes) return std::nullopt;
    return *bytes;
}

wire::FeedbackBlock RobotSim::measure() {
    // The FPGA does the measuring: without it there is nothing to tell.
    if (!fpga_ || scheduler_.now() < validFrom_) return {};
    std::uint64_t dice = noisy_ ? noise_() : 0;
    const auto reading = [&dice](std::uint16_t adc, std::uint16_t highest) {
        const int off = static_cast<int>(dice & 1) - static_cast<int>(dice >> 1 & 1);
        dice >>= 2;
        return static_cast<std::uint16_t>(std::clamp(adc + off, 0, static_cast<int>(highest)));
    };
    wire::FeedbackBlock block;
    block.valid = true;
    block.ball = beam_.ball();
    block.charged = body_.capacitor.charged();
    block.battery_adc = reading(wire::battery_adc(body_.battery.terminal_V()), wire::kMaxAdc10);
    block.capacitor_adc = reading(wire::capacitor_adc(body_.capacitor.volts()), wire::kMaxAdc12);
    block.thermistor_adc = reading(body_.dribbler.thermistor_adc(), wire::kMaxAdc10);
    block.light_adc = reading(beam_.light_adc(), wire::kMaxAdc10);
    return block;
}

void RobotSim::send(wire::Pipe pipe, const wire::MessagePayload& payload, bool rebootAfterwards) {
    if (outgoing_.size() == kMaxOutgoing) {
        ++lostMessages_;
        return;
    }
    outgoing_.push_back({pipe, payload, rebootAfterwards});
    if (listener_.messageWaiting) listener_.messageWaiting();
}

void RobotSim::outgoingDelivered() {
    if (outgoing_.empty()) return;
    const bool reboots = outgoing_.front().rebootAfterwards;
    outgoing_.pop_front();
    if (reboots) reboot();
}

void RobotSim::dropOutgoing() {
    const bool reboots = std::ranges::any_of(outgoing_, &OutgoingMessage::rebootAfterwards);
    lostMessages_ += outgoing_.size();
    outgoing_.clear();
    if (reboots) reboot();
}

void RobotSim::sendExperiment() {
    advance();
    if (!up()) return;
    for (std::size_t offset = 0; offset < wire::kExperimentBufferBytes;
         offset += wire::kExperimentPieceBytes) {
        wire::ExperimentData piece{.offset = static_cast<std::uint8_t>(offset)};
        for (std::size_t i = 0; i < piece.data.size(); ++i)
            piece.data[i] = static_cast<std::uint8_t>(offset + i);
        if (const auto bytes = wire::encodeIndicator(piece)) send(wire::Pipe::Indicator, *bytes);
    }
}

// ---- Hands from outside ----

void RobotSim::setBall(bool ball) {
    advance();
    beam_.setBall(ball, scheduler_.now());
    considerAutokick();
}

void RobotSim::setBattery(double volts) {
    advance();
    body_.battery.setRest(volts);
    detailEnd_ = time_ + kSettled;
}

void RobotSim::setCapacitor(double volts) {
    advance();
    body_.capacitor.set(volts);
    detailEnd_ = time_ + kSettled;
}

void RobotSim::setTemperature(double celsius) {
    advance();
    body_.dribbler.setTemperature(celsius);
}

void RobotSim::setDeadWheels(std::uint8_t wheels) {
    advance();
    body_.deadWheels = wheels;
    detailEnd_ = time_ + kSettled;
}

void RobotSim::setChargerBroken(bool broken) {
    advance();
    body_.chargerBroken = broken;
    detailEnd_ = time_ + kSettled;
}

void RobotSim::switchPower(bool on) {
    advance();
    const bool running = power_ != RobotPower::Off && power_ != RobotPower::LockedOut;
    if (on && running) return;
    body_.battery.switchOff();
    if (on) {
        boot();
    } else if (power_ != RobotPower::Off) {
        powerDown(RobotPower::Off);
    }
}

// ---- Power ----

void RobotSim::powerDown(RobotPower state) {
    bootTimer_.stop();
    lockOutTimer_.stop();
    firmware_.reset();
    beam_.forgetLockOut();
    lostMessages_ += outgoing_.size();
    outgoing_.clear();
    driveFresh_ = false;
    act(wire::brakedBlock());
    testMode_ = {};
    power_ = state;
    if (listener_.powerChanged) listener_.powerChanged();
}

void RobotSim::reboot() {
    advance();
    if (!up()) return;
    powerDown(RobotPower::Booting);
    boot();
}

void RobotSim::boot() {
    power_ = RobotPower::Booting;
    bootTimer_.start(kBootTime, [this] { bootDone(); });
}

void RobotSim::bootDone() {
    advance();
    if (power_ != RobotPower::Booting) return;
    controller_.reload();
    if (controller_.shadow().flash() != wire::FlashContents::Microcontroller) return comeUp();
    power_ = RobotPower::CopyingImage;
    bootTimer_.start(kCopyTime, [this] {
        advance();
        if (power_ != RobotPower::CopyingImage) return;
        controller_.copyProgram(flash_);
        controller_.commitNoData();
        boot();
    });
}

void RobotSim::comeUp() {
    configure();
    validFrom_ = scheduler_.now() + kFirstReadings;
    power_ = RobotPower::Up;
    if (listener_.powerChanged) listener_.powerChanged();
}

void RobotSim::configure() {
    const wire::OperationalParameters& parameters = controller_.shadow();
    number_ = parameters.robotNumber;
    channels_ = {parameters.channel0, parameters.channel1};
    fpga_ = parameters.flash() == wire::FlashContents::FpgaBitstream && !flash_.blank();
    ++boots_;
}

// ---- A look ----

RobotReport RobotSim::report() {
    advance();
    RobotReport report;
    report.power = power_;
    report.boots = boots_;
    report.number = number_;
    report.channels = channels_;
    report.fpgaConfigured = fpga_;
    report.driveFresh = driveFresh_;
    report.lastDrive = lastDrive_;
    report.lastDriveTime = driveTime_;
    report.driveBlocks = driveBlocks_;
    report.driveChanges = driveChanges_;
    report.driveTimeouts = driveTimeouts_;
    report.kicks = kicks_;
    report.automaticKicks = automaticKicks_;
    report.lastKicks = lastKicks_;
    report.testMode = shownTestMode();
    report.testModeMessages = testModeMessages_;
    report.leds = up() && fpga_ ? testLeds(report.testMode, body_) : 0;
    for (std::size_t i = 0; i < body_.wheels.size(); ++i) {
        report.wheelSpeeds[i] = body_.wheels[i].speed();
        report.wheelCounts[i] = body_.wheels[i].count();
    }
    report.battery_V = body_.battery.terminal_V();
    report.capacitor_V = body_.capacitor.volts();
    report.dribbler_C = body_.dribbler.temperature_C();
    report.charging = body_.capacitor.charging();
    report.dribbling = body_.dribbler.running();
    report.ball = beam_.ball();
    report.shadow = controller_.shadow();
    report.committed = controller_.committed();
    report.malformed = malformed_ + firmware_.ignored();
    report.wrongCrcs = firmware_.wrongCrcs();
    report.lostMessages = lostMessages_;
    return report;
}

}  // namespace kickstand::thunderbots::sim
