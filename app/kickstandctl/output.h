#pragma once

#include <QJsonValue>
#include <QStringList>

#include "app/kickstandctl/failure.h"

namespace kickstand::ctl {

class Interruption;

/// Where a command writes: standard output, as text or as JSON, each line at once. A reader that has gone is
/// not an accident but a state, failed(). Main thread.
class Output {
  public:
    /// A reader that takes nothing is waited for until `interruption` says otherwise; robots brake meanwhile,
    /// for want of a heartbeat.
    Output(bool json, Interruption& interruption) : json_(json), interruption_(interruption) {}

    bool isJson() const { return json_; }
    /// Whether something could not be written: the reader is gone, or the disk is full.
    bool failed() const { return failed_; }
    /// Whether a JSON value was written.
    bool hasValue() const { return hasValue_; }

    /// One JSON value in one line, members in alphabetical order; nothing in text mode.
    void value(const QJsonValue& value);
    /// One line of text; nothing in JSON mode.
    void line(const QString& text);
    /// Lines whose columns stand below each other. A cell whose first row begins with "<" stands to the
    /// right.
    void table(const QList<QStringList>& rows);
    /// As it is, in either mode.
    void raw(const QString& text);

    /// Standard error: what, and what to do, in one line.
    static void complain(const Failure& failure, const char* program = "kickstandctl");

  private:
    bool writable();

    const bool json_;
    Interruption& interruption_;
    bool failed_ = false;
    bool hasValue_ = false;
};

/// Descriptors 0, 1 and 2 exist afterwards, so that no device can be opened in their place and written to.
void reserveStandardStreams();

}  // namespace kickstand::ctl
