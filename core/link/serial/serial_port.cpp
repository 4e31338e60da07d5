#include "core/link/serial/serial_port.h"

#include <QFileInfo>
#include <QSerialPort>
#include <QSerialPortInfo>
#include <QTimer>
#include <algorithm>
#include <utility>

namespace kickstand::serial {
namespace {

/// How long close() lets what waits be sent.
constexpr int kLinger_ms = 200;
/// How often a port that is not there is looked for.
constexpr int kLookEvery_ms = 250;
/// What may be read and not yet taken by the receiver.
constexpr std::size_t kUntaken = 1U << 20;
constexpr qint64 kReadBuffer = 65536;

/// The same port under each of its names, so that the lock that keeps two programs apart is one lock.
QString systemName(const std::string& name) {
    const QString given = QString::fromStdString(name);
    const QFileInfo file(given);
    const QString real = file.isAbsolute() ? file.canonicalFilePath() : QString();
    return real.isEmpty() ? given : real;
}

Error errorOf(const QSerialPort& port, const std::string& name) {
    Error error;
    error.port = name;
    error.detail = port.errorString().toStdString();
    switch (port.error()) {
        case QSerialPort::DeviceNotFoundError:
            error.code = Errc::NoDevice;
            break;
        case QSerialPort::PermissionError: {
            // The same word for both: "held by another program" and "not for this user".
            const QFileInfo file(port.portName().startsWith(u'/')
                                     ? port.portName()
                                     : QStringLiteral("/dev/") + port.portName());
            const bool allowed = !file.exists() || (file.isReadable() && file.isWritable());
            error.code = allowed ? Errc::ClaimedElsewhere : Errc::PermissionDenied;
            break;
        }
        case QSerialPort::OpenError:
            error.code = Errc::ClaimedElsewhere;
            break;
        default:
            error.code = portExists(name) ? Errc::Io : Errc::NoDevice;
    }
    return error;
}

/// Errors after which a port still works: settings that a pseudo-terminal does not have, and the like.
bool isHarmless(QSerialPort::SerialPortError error) {
    return error == QSerialPort::NoError || error == QSerialPort::UnsupportedOperationError ||
           error == QSerialPort::TimeoutError;
}

}  // namespace

bool portExists(const std::string& name) {
    const QString given = QString::fromStdString(name);
    if (QFileInfo(given).isAbsolute()) return QFileInfo::exists(given);
    return !QSerialPortInfo(given).isNull();
}

std::string describePort(const std::string& name) {
    return QSerialPortInfo(QFileInfo(systemName(name)).fileName()).description().toStdString();
}

/// The port's side that lives on its thread.
class Port::Worker final : public QObject {
  public:
    Worker(std::string name, PortEvents events) : name_(std::move(name)), events_(std::move(events)) {}

    void open(Baud baud) {
        looking_ = nullptr;
        port_ = std::make_unique<QSerialPort>(systemName(name_));
        port_->setReadBufferSize(kReadBuffer);
        port_->setBaudRate(static_cast<qint32>(baud));
        if (!port_->open(QIODevice::ReadWrite)) {
            Error error = errorOf(*port_, name_);
            port_ = nullptr;
            if (error.code == Errc::NoDevice) look();
            return events_.opened(fail(std::move(error)));
        }
        // What the device said before was said to whoever held the port then.
        port_->clear(QSerialPort::Input);
        untaken_ = 0;
        connect(port_.get(), &QSerialPort::readyRead, this, [this] { read(); });
        connect(port_.get(), &QSerialPort::bytesWritten, this, [this](qint64 bytes) { written(bytes); });
        connect(port_.get(), &QSerialPort::errorOccurred, this,
                [this](QSerialPort::SerialPortError error) { failed(error); });
        events_.opened(ByteLinkInfo{name_, describePort(name_), baud});
    }

    void close() {
        if (port_ == nullptr || port_->bytesToWrite() == 0) return finish();
        closing_ = std::make_unique<QTimer>();
        closing_->setSingleShot(true);
        connect(closing_.get(), &QTimer::timeout, this, [this] { finish(); });
        closing_->start(kLinger_ms);
    }

    void write(const std::vector<std::uint8_t>& bytes) {
        if (port_ == nullptr) return;
        port_->write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    }

    void setBaud(Baud baud, const std::function<void(Result<void>)>& done) {
        if (port_ == nullptr) return done(failAt(Errc::Cancelled));
        // A port that refuses a speed goes on at the one that it has; one that is gone says so by itself.
        const QSignalBlocker quiet(port_.get());
        if (port_->setBaudRate(static_cast<qint32>(baud))) return done({});
        port_->clearError();
        done(failAt(Errc::Io));
    }

    void taken(std::size_t bytes) {
        untaken_ -= std::min(bytes, untaken_);
        read();
    }

  private:
    tl::unexpected<Error> failAt(Errc code) const {
        Error error;
        error.code = code;
        error.port = name_;
        return kickstand::fail(std::move(error));
    }

    void read() {
        if (port_ == nullptr || untaken_ >= kUntaken) return;
        const QByteArray bytes = port_->readAll();
        if (bytes.isEmpty()) return;
        untaken_ += static_cast<std::size_t>(bytes.size());
        events_.received({bytes.begin(), bytes.end()});
    }

    void written(qint64 bytes) {
        events_.sent(static_cast<std::size_t>(bytes));
        if (closing_ != nullptr && port_->bytesToWrite() == 0) finish();
    }

    void failed(QSerialPort::SerialPortError error) {
        if (port_ == nullptr || isHarmless(error)) return;
        // At once, and deaf to what follows: a port whose other end has gone says so without end.
        const bool closing = closing_ != nullptr;
        port_->disconnect(this);
        read();
        release();
        if (closing) return events_.closed();
        events_.lost();
        look();
    }

    void finish() {
        if (port_ != nullptr) {
            port_->disconnect(this);
            if (port_->bytesToWrite() > 0) port_->clear(QSerialPort::Output);
        }
        release();
        events_.closed();
    }

    /// Closes the port; it is deleted later, since this may be called by one of its own signals.
    void release() {
        if (closing_ != nullptr) closing_.release()->deleteLater();
        if (port_ == nullptr) return;
        port_->close();
        port_.release()->deleteLater();
    }

    void look() {
        looking_ = std::make_unique<QTimer>();
        connect(looking_.get(), &QTimer::timeout, this, [this] {
            if (!portExists(name_)) return;
            looking_->stop();
            looking_.release()->deleteLater();
            events_.appeared();
        });
        looking_->start(kLookEvery_ms);
    }

    const std::string name_;
    const PortEvents events_;
    std::unique_ptr<QSerialPort> port_;
    std::unique_ptr<QTimer> closing_;
    std::unique_ptr<QTimer> looking_;
    std::size_t untaken_ = 0;
};

Port::Port(std::string name, PortEvents events) : worker_(new Worker(std::move(name), std::move(events))) {
    worker_->moveToThread(&thread_);
    QObject::connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
    thread_.setObjectName(QStringLiteral("serial port"));
    thread_.start();
}

Port::~Port() {
    thread_.quit();
    thread_.wait();
}

void Port::run(std::function<void(Worker&)> job) {
    QMetaObject::invokeMethod(
        worker_, [worker = worker_, job = std::move(job)] { job(*worker); }, Qt::QueuedConnection);
}

void Port::open(Baud baud) {
    run([baud](Worker& worker) { worker.open(baud); });
}

void Port::close() {
    run([](Worker& worker) { worker.close(); });
}

void Port::write(std::vector<std::uint8_t> bytes) {
    run([bytes = std::move(bytes)](Worker& worker) { worker.write(bytes); });
}

void Port::setBaud(Baud baud, std::function<void(Result<void>)> done) {
    run([baud, done = std::move(done)](Worker& worker) { worker.setBaud(baud, done); });
}

void Port::taken(std::size_t bytes) {
    run([bytes](Worker& worker) { worker.taken(bytes); });
}

}  // namespace kickstand::serial
