#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/ledger/parameter_record.h"

struct sqlite3;
struct sqlite3_stmt;

namespace kickstand {

/// The ledger's file. Blocks: used on the ledger's own thread. Every error's subject is the file. Errc:
/// TimedOut where another program holds it, and trying again later may help; Malformed where it is damaged or
/// no ledger; Unsupported where a newer version made it; Io for the rest.
class LedgerStore {
  public:
    LedgerStore() = default;

    /// Opens the file, makes it where there is none, and looks whether it is a ledger.
    Result<void> open(const std::string& file);
    bool isOpen() const { return database_ != nullptr; }

    Result<void> add(const ParameterRecord& record);
    Result<void> add(const SignatureRecord& signatures);
    Result<void> setNote(std::int64_t id, const std::string& note);

    /// The newest `most` records, newest first.
    struct Listing {
        std::vector<ParameterRecord> records;
        std::uint64_t unreadable = 0;
    };
    Result<Listing> newest(std::size_t most);

  private:
    struct CloseDatabase {
        void operator()(sqlite3* database) const;
    };
    struct EndStatement {
        void operator()(sqlite3_stmt* statement) const;
    };
    using Statement = std::unique_ptr<sqlite3_stmt, EndStatement>;

    Result<void> checkWhole();
    Result<void> prepareFile();
    Result<Statement> prepare(const char* sql);
    Result<void> run(const char* sql);
    Result<void> run(const Statement& statement);
    Result<std::int64_t> number(const char* sql);
    Error errorOf(int code) const;

    std::string file_;
    std::unique_ptr<sqlite3, CloseDatabase> database_;
    std::int64_t run_ = 0;  ///< Tells the records of this opening from those of earlier ones.
};

}  // namespace kickstand
