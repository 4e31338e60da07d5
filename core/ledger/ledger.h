#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <variant>

#include "core/base/time.h"
#include "core/ledger/parameter_record.h"

namespace kickstand {

/// The fleet's history in an SQLite file, so that what a robot was told once can be looked up and told again.
/// All work on the file is done on a thread of the ledger's own. A file that is locked is tried again, with
/// what is to be written kept meanwhile; one that is damaged or not a ledger is left alone, and said so.
/// Every method may be called from any thread, and none waits for the file but flush().
class Ledger {
  public:
    /// Changes that may wait to be written; one more is lost, and counted.
    static constexpr std::size_t kCapacity = 1024;
    /// Records that a view shows.
    static constexpr std::size_t kMostShown = 2000;
    /// Bytes of a note; a longer one is cut.
    static constexpr std::size_t kLongestNote = 1000;

    /// Opens the file, and makes it where there is none. ":memory:" is forgotten with the ledger.
    explicit Ledger(std::string file);
    /// Writes what waits, unless the file cannot be written now.
    ~Ledger();
    Ledger(const Ledger&) = delete;
    Ledger& operator=(const Ledger&) = delete;

    /// Keeps a record. False, and counted, where too much waits already.
    bool add(ParameterRecord record);
    /// Adds signatures to the newest record that this ledger has made of that robot, if it has none yet.
    bool add(const SignatureRecord& signatures);
    /// Puts a note in place of a record's note.
    bool setNote(std::int64_t id, std::string note);

    /// The latest state of it.
    LedgerView view() const;
    /// Waits until all that was asked for so far has been tried, but not for longer than this. False where
    /// something still waits.
    bool flush(Duration limit);

  private:
    struct Note {
        std::int64_t id = 0;
        std::string text;
    };
    using Change = std::variant<ParameterRecord, SignatureRecord, Note>;
    class Store;

    bool push(Change change);
    void run(const std::string& file);
    /// Opens the file where it is not open, and writes what waits. False where that has to be tried again.
    bool work(Store& store, const std::string& file, std::unique_lock<std::mutex>& lock);
    bool openFile(Store& store, const std::string& file, std::unique_lock<std::mutex>& lock);
    void readNewest(Store& store, std::unique_lock<std::mutex>& lock);
    void setError(std::optional<Error> error);

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable idle_;
    std::deque<Change> changes_;
    LedgerView view_;
    bool idling_ = false;  ///< All that was asked for has been tried.
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace kickstand
