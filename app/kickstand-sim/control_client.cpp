#include "app/kickstand-sim/control_client.h"

#include <QJsonDocument>

#include "app/kickstand-sim/json.h"
#include "app/kickstand-sim/run_on.h"
#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

constexpr Duration kConnectLimit = std::chrono::seconds(5);
/// A simulator that serves a busy link answers within milliseconds.
constexpr Duration kAnswerLimit = std::chrono::seconds(10);
constexpr Duration kLook = std::chrono::milliseconds(50);

ctl::Failure explain(const Error& error, const std::string& path) {
    ctl::Failure failure = ctl::failed(error).value();
    const QString why = error.detail.empty() ? QLatin1String(name(error.code)) : printable(error.detail);
    failure.text = {Words::tr("No simulator answers at %1: %2.").arg(printable(path), why),
                    Words::tr("Start one, as kickstand-sim thunderbots --usbip, or name its control socket "
                              "with --control PATH."),
                    {}};
    return failure;
}

tl::unexpected<ctl::Failure> lost(Errc code, const QString& what) {
    return tl::unexpected<ctl::Failure>(
        {ctl::kFailed, {what, Words::tr("See what the simulator says."), {}}, QLatin1String(name(code))});
}

}  // namespace

ControlClient::~ControlClient() {
    runOn(scheduler_, [this] {
        stream_.reset();
        sockets_.reset();
    });
}

ctl::Outcome ControlClient::connect(const std::string& path) {
    runOn(scheduler_, [&] {
        sockets_ = std::make_unique<Sockets>(scheduler_);
        sockets_->connectLocal(path, kConnectLimit, [this](Result<std::unique_ptr<ByteStream>> stream) {
            connected(std::move(stream));
        });
    });
    std::unique_lock lock(mutex_);
    if (!waitFor(
            lock, [this] { return connected_.has_value(); }, 2 * kConnectLimit))
        return lost(Errc::Cancelled, Words::tr("The simulator was not reached."));
    if (!*connected_) return tl::unexpected(explain(connected_->error(), path));
    return {};
}

bool ControlClient::waitFor(std::unique_lock<std::mutex>& lock, const std::function<bool()>& ready,
                            Duration limit) {
    const TimePoint end = scheduler_.now() + limit;
    while (!ready()) {
        interruption_.wait(Duration::zero());
        if (interruption_.cause() || scheduler_.now() >= end) return false;
        changed_.wait_for(lock, kLook);
    }
    return true;
}

void ControlClient::connected(Result<std::unique_ptr<ByteStream>> stream) {
    if (stream) {
        stream_ = std::move(*stream);
        stream_->start({.received = [this](ByteView bytes) { received(bytes); },
                        .closed = [this](const Error&) { ended(); }});
    }
    const std::lock_guard lock(mutex_);
    connected_ = stream.map([](const auto&) {});
    changed_.notify_all();
}

void ControlClient::received(ByteView bytes) {
    const std::lock_guard lock(mutex_);
    lines_.take(
        bytes, [this](ByteView line) { answers_.emplace_back(line.begin(), line.end()); },
        [this] { ended_ = true; });
    changed_.notify_all();
}

void ControlClient::ended() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
}

ctl::Expected<QJsonObject> ControlClient::ask(const QJsonObject& request) {
    const std::string line = compact(request).toStdString() + '\n';
    scheduler_.post([this, line] {
        stream_->send({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
    });
    std::string answer;
    {
        std::unique_lock lock(mutex_);
        const bool came = waitFor(
            lock, [this] { return ended_ || !answers_.empty(); }, kAnswerLimit);
        if (!came) return lost(Errc::TimedOut, Words::tr("The simulator does not answer."));
        if (answers_.empty()) return lost(Errc::Disconnected, Words::tr("The simulator hung up."));
        answer = std::move(answers_.front());
        answers_.pop_front();
    }
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(answer));
    if (!document.isObject())
        return lost(Errc::Malformed, Words::tr("What answers there is no simulator of this program."));
    const QJsonObject json = document.object();
    if (!json[QStringLiteral("ok")].toBool()) return tl::unexpected(failureFrom(json));
    return json;
}

}  // namespace kickstand::sim
