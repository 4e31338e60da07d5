#include "core/ledger/ledger_store.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <sqlite3.h>

namespace kickstand {
namespace {

using std::chrono::milliseconds;

/// "KSTD": what tells a ledger from another program's database.
constexpr std::int64_t kApplication = 1263752260;
constexpr std::int64_t kSchema = 1;
/// How long another program's own write is waited for.
constexpr int kBusy_ms = 1000;
/// More than any robot sends; a longer blob was not written by this program.
constexpr int kMostBlockBytes = 255;
constexpr int kMostTextBytes = 4096;

constexpr char kMakeTables[] =
    "BEGIN IMMEDIATE;"
    "CREATE TABLE parameters ("
    " id INTEGER PRIMARY KEY, run INTEGER NOT NULL, time_ms INTEGER NOT NULL, source TEXT NOT NULL,"
    " robot INTEGER NOT NULL, block BLOB NOT NULL, microcontroller INTEGER, flash INTEGER,"
    " note TEXT NOT NULL DEFAULT '');"
    "PRAGMA application_id = 1263752260;"
    "PRAGMA user_version = 1;"
    "COMMIT;";

void bindText(sqlite3_stmt* statement, int index, const std::string& text) {
    sqlite3_bind_text64(statement, index, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void bindMaybe(sqlite3_stmt* statement, int index, const std::optional<std::uint16_t>& value) {
    if (value) sqlite3_bind_int(statement, index, *value);
}

std::optional<std::string> readText(sqlite3_stmt* row, int column) {
    if (sqlite3_column_type(row, column) != SQLITE_TEXT) return std::nullopt;
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
    const int length = sqlite3_column_bytes(row, column);
    if (text == nullptr || length > kMostTextBytes) return std::nullopt;
    return std::string(text, static_cast<std::size_t>(length));
}

/// A signature, nothing where there is none, or false where it is no signature.
bool readMaybe(sqlite3_stmt* row, int column, std::optional<std::uint16_t>& value) {
    if (sqlite3_column_type(row, column) == SQLITE_NULL) return true;
    const std::int64_t number = sqlite3_column_int64(row, column);
    if (sqlite3_column_type(row, column) != SQLITE_INTEGER || number < 0 || number > 0xFFFF) return false;
    value = static_cast<std::uint16_t>(number);
    return true;
}

/// A row as a record, if it is one: the file is as trustworthy as whoever wrote to it.
std::optional<ParameterRecord> readRow(sqlite3_stmt* row) {
    ParameterRecord record;
    record.id = sqlite3_column_int64(row, 0);
    const std::int64_t time_ms = sqlite3_column_int64(row, 1);
    const std::int64_t robot = sqlite3_column_int64(row, 3);
    auto source = readText(row, 2);
    auto note = readText(row, 7);
    const int length = sqlite3_column_bytes(row, 4);
    const auto* block = static_cast<const std::uint8_t*>(sqlite3_column_blob(row, 4));
    constexpr std::int64_t kYear9999_ms = 253402300799999;
    if (sqlite3_column_type(row, 4) != SQLITE_BLOB || block == nullptr || length > kMostBlockBytes ||
        robot < 0 || robot > 255 || time_ms < 0 || time_ms > kYear9999_ms || !source || !note)
        return std::nullopt;
    if (!readMaybe(row, 5, record.microcontrollerSignature) || !readMaybe(row, 6, record.flashSignature))
        return std::nullopt;
    record.time = std::chrono::system_clock::time_point(milliseconds(time_ms));
    record.robot = static_cast<int>(robot);
    record.source = *std::move(source);
    record.note = *std::move(note);
    record.block.assign(block, block + length);
    return record;
}

std::int64_t toMilliseconds(std::chrono::system_clock::time_point time) {
    return std::chrono::duration_cast<milliseconds>(time.time_since_epoch()).count();
}

}  // namespace

void LedgerStore::CloseDatabase::operator()(sqlite3* database) const {
    sqlite3_close_v2(database);
}

void LedgerStore::EndStatement::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Error LedgerStore::errorOf(int code) const {
    Error error;
    error.subject = file_;
    error.detail = database_ ? sqlite3_errmsg(database_.get()) : sqlite3_errstr(code);
    switch (code & 0xFF) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            error.code = Errc::TimedOut;
            break;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
        case SQLITE_MISMATCH:
        case SQLITE_ERROR:
            // A statement that does not fit the file is the file's fault: they are all written here.
            error.code = Errc::Malformed;
            break;
        default:
            error.code = Errc::Io;
    }
    return error;
}

Result<void> LedgerStore::open(const std::string& file) {
    file_ = file;
    sqlite3* database = nullptr;
    const int opened = sqlite3_open_v2(
        file.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
    database_.reset(database);
    if (opened != SQLITE_OK) {
        Error error = errorOf(opened);
        database_.reset();
        return fail(std::move(error));
    }
    sqlite3_busy_timeout(database_.get(), kBusy_ms);
    // What a hostile schema could otherwise run.
    sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    auto prepared = prepareFile();
    if (!prepared) database_.reset();
    return prepared;
}

Result<void> LedgerStore::checkWhole() {
    auto statement = prepare("PRAGMA quick_check(1)");
    if (!statement) return tl::unexpected(std::move(statement.error()));
    const int code = sqlite3_step(statement->get());
    if (code != SQLITE_ROW) return fail(errorOf(code));
    if (const auto verdict = readText(statement->get(), 0); verdict != "ok")
        return fail(Errc::Malformed, file_, verdict.value_or("it is damaged"));
    return {};
}

Result<void> LedgerStore::prepareFile() {
    if (auto whole = checkWhole(); !whole) return whole;
    const auto application = number("PRAGMA application_id");
    if (!application) return tl::unexpected(application.error());
    const auto version = number("PRAGMA user_version");
    if (!version) return tl::unexpected(version.error());
    const auto tables = number("SELECT count(*) FROM sqlite_master");
    if (!tables) return tl::unexpected(tables.error());
    if (*application == 0 && *version == 0 && *tables == 0) {
        // Another program may be doing just this: then its tables are there in a moment.
        if (auto made = run(kMakeTables); !made) {
            sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
            const auto now = number("PRAGMA application_id");
            if (!now || *now != kApplication) return made;
        }
    } else if (*application != kApplication) {
        return fail(Errc::Malformed, file_, "it belongs to another program");
    } else if (*version > kSchema) {
        return fail(Errc::Unsupported, file_, "a newer version of the program made it");
    }
    const auto last = number("SELECT coalesce(max(run), 0) FROM parameters");
    if (!last) return tl::unexpected(last.error());
    // Openings at the same moment are told apart by the clock, and by what is there.
    run_ = std::max(*last + 1, toMilliseconds(std::chrono::system_clock::now()));
    return {};
}

Result<LedgerStore::Statement> LedgerStore::prepare(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr);
    if (code != SQLITE_OK) return fail(errorOf(code));
    return Statement(statement);
}

Result<void> LedgerStore::run(const char* sql) {
    const int code = sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) return fail(errorOf(code));
    return {};
}

Result<void> LedgerStore::run(const Statement& statement) {
    const int code = sqlite3_step(statement.get());
    if (code != SQLITE_DONE) return fail(errorOf(code));
    return {};
}

Result<std::int64_t> LedgerStore::number(const char* sql) {
    auto statement = prepare(sql);
    if (!statement) return tl::unexpected(std::move(statement.error()));
    const int code = sqlite3_step(statement->get());
    if (code != SQLITE_ROW) return fail(errorOf(code));
    return sqlite3_column_int64(statement->get(), 0);
}

Result<void> LedgerStore::add(const ParameterRecord& record) {
    auto statement = prepare(
        "INSERT INTO parameters (run, time_ms, source, robot, block, microcontroller, flash, note)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    if (!statement) return tl::unexpected(std::move(statement.error()));
    sqlite3_stmt* row = statement->get();
    sqlite3_bind_int64(row, 1, run_);
    sqlite3_bind_int64(row, 2, toMilliseconds(record.time));
    bindText(row, 3, record.source);
    sqlite3_bind_int(row, 4, record.robot);
    sqlite3_bind_blob64(row, 5, record.block.data(), record.block.size(), SQLITE_TRANSIENT);
    bindMaybe(row, 6, record.microcontrollerSignature);
    bindMaybe(row, 7, record.flashSignature);
    bindText(row, 8, record.note);
    return run(*statement);
}

Result<void> LedgerStore::add(const SignatureRecord& signatures) {
    auto statement = prepare(
        "UPDATE parameters SET microcontroller = ?, flash = ? WHERE microcontroller IS NULL AND id ="
        " (SELECT max(id) FROM parameters WHERE run = ? AND source = ? AND robot = ?)");
    if (!statement) return tl::unexpected(std::move(statement.error()));
    sqlite3_stmt* row = statement->get();
    sqlite3_bind_int(row, 1, signatures.microcontroller);
    sqlite3_bind_int(row, 2, signatures.flash);
    sqlite3_bind_int64(row, 3, run_);
    bindText(row, 4, signatures.source);
    sqlite3_bind_int(row, 5, signatures.robot);
    return run(*statement);
}

Result<void> LedgerStore::setNote(std::int64_t id, const std::string& note) {
    auto statement = prepare("UPDATE parameters SET note = ? WHERE id = ?");
    if (!statement) return tl::unexpected(std::move(statement.error()));
    bindText(statement->get(), 1, note);
    sqlite3_bind_int64(statement->get(), 2, id);
    return run(*statement);
}

Result<LedgerStore::Listing> LedgerStore::newest(std::size_t most) {
    auto statement = prepare(
        "SELECT id, time_ms, source, robot, block, microcontroller, flash, note FROM parameters"
        " ORDER BY id DESC LIMIT ?");
    if (!statement) return tl::unexpected(std::move(statement.error()));
    sqlite3_bind_int64(statement->get(), 1, static_cast<std::int64_t>(most));
    Listing listing;
    int code = sqlite3_step(statement->get());
    for (; code == SQLITE_ROW; code = sqlite3_step(statement->get())) {
        if (auto record = readRow(statement->get())) {
            listing.records.push_back(*std::move(record));
        } else {
            ++listing.unreadable;
        }
    }
    if (code != SQLITE_DONE) return fail(errorOf(code));
    return listing;
}

}  // namespace kickstand
