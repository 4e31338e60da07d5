#pragma once

#include <QByteArray>

#include "app/kickstand-sim/simulation.h"
#include "app/kickstandctl/failure.h"

namespace kickstand::sim {

/// The longest line that a client may send, in bytes.
inline constexpr std::size_t kMaxRequestBytes = 4096;
/// The most of a flash memory that one answer carries.
inline constexpr std::uint32_t kMaxFlashPiece = 65536;

/// Answers what is asked of a simulator from outside the wire: a JSON object a line, and one in return. No
/// sockets here. The requests:
/// - {"request": "actions"}: what there is to do, with units, bounds and words.
/// - {"request": "perform", "action": "ball", "robot": 3, "value": 1}: does it. "robot" may be "all"; "value"
///   a number or one of the action's words. Both stand only where the action takes them.
/// - {"request": "show"}, {"request": "show", "robot": 3}: what came and what goes on, of all or of one.
/// - {"request": "flash", "robot": 3, "address": 0, "length": 4096}: a piece of a flash memory, in base64.
/// Every answer has "ok"; a refusal "error" with "code", "what" and "remedy". An "id" comes back as it was.
/// On the simulator's thread.
class ControlDesk {
  public:
    /// All of them must outlive it; there need not be a carrier.
    explicit ControlDesk(Simulation& simulation, const Carrier* carrier = nullptr)
        : simulation_(simulation), carrier_(carrier) {}

    /// One line, without its end, for another. Any bytes are taken.
    QByteArray answer(ByteView line);
    /// The answer to a line that was longer than kMaxRequestBytes.
    static QByteArray answerToTooLong();

  private:
    using Answer = ctl::Expected<QJsonObject>;

    Answer handle(const QJsonObject& request);
    Answer actions() const;
    Answer perform(const QJsonObject& request);
    Answer performOn(const SimAction& action, const QJsonObject& request, const QJsonValue& value);
    Answer show(const QJsonObject& request);
    Answer flash(const QJsonObject& request) const;

    ctl::Expected<int> readUnit(const QJsonValue& value) const;
    ctl::Expected<double> readValue(const SimAction& action, const QJsonValue& value) const;
    QString unitKey() const;

    Simulation& simulation_;
    const Carrier* carrier_;
};

}  // namespace kickstand::sim
