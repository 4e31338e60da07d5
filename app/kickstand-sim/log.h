#pragma once

#include <QJsonObject>
#include <QString>
#include <cstdint>
#include <mutex>
#include <string>

namespace kickstand::sim {

/// Standard output of a program that must not wait for its reader: a line that finds no room is left out,
/// and the next one that does says how many were. As text, or as JSON objects a line. Any thread.
class Log {
  public:
    explicit Log(bool json) : json_(json) {}
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    /// What is to be said once: `text` as it is, or `facts` where JSON was asked for.
    void announce(const QString& text, const QJsonObject& facts);
    /// Something that happened, in words, with its time.
    void event(const std::string& text);

  private:
    void write(const QByteArray& line);

    const bool json_;
    std::mutex mutex_;
    std::uint64_t leftOut_ = 0;
};

}  // namespace kickstand::sim
