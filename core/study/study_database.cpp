#include "core/study/study_database.h"

#include <sqlite3.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr int kLockPatience = 60000;  // ms to wait for another process

/// Throws InputError where the file is there and is no database.
void requireDatabase(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error) || fs::file_size(file, error) == 0) return;
  const RegularFile present(file);
  const std::string start = present.read(0, 16);
  if (start.starts_with("SQLite format 3")) return;
  const std::string_view kind = detectNonText(start);
  throw InputError(file.string(), "",
                   kind.empty() ? message("is not the store of a study")
                                : message("is not the store of a study, but {}", Message(kind)));
}

}  // namespace

void StudyDatabase::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

StudyDatabase::StudyDatabase(fs::path file, Access access) : file_(std::move(file)) {
  requireDatabase(file_);
  // A killed process leaves changes that only a writer can take over. SQLite falls back to reading
  // where the file is protected.
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_READWRITE;
  if (access != Access::Read) flags |= SQLITE_OPEN_CREATE;
  // An absolute name cannot be taken for a URI or for one of SQLite's own names.
  const std::string name = fs::absolute(file_).string();
  sqlite3* connection = nullptr;
  const int opened = sqlite3_open_v2(name.c_str(), &connection, flags, nullptr);
  connection_.reset(connection);
  if (opened != SQLITE_OK) fail(opened);
  sqlite3_extended_result_codes(connection, 1);
  sqlite3_busy_timeout(connection, kLockPatience);
  if (access == Access::Read) return;
  if (access == Access::WriteAlone) execute("PRAGMA locking_mode=EXCLUSIVE");
  // SQLite itself does not wait for another process that changes the mode at the same moment.
  for (int tries = 0;; ++tries) {
    const int status =
        sqlite3_exec(connection_.get(), "PRAGMA journal_mode=WAL", nullptr, nullptr, nullptr);
    if (status == SQLITE_OK) break;
    if ((status & 0xFF) != SQLITE_BUSY || tries == kLockPatience / 20) fail(status);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  execute("PRAGMA synchronous=NORMAL");
}

InputError damagedStore(const std::filesystem::path& file, const std::string& reason) {
  return {file.string(), "",
          message("is damaged ({}); the study has to be run into another store, or merged from "
                  "intact ones",
                  Message::name(reason))};
}

void StudyDatabase::fail(int status) const {
  const std::string file = file_.string();
  const std::string reason =
      connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(status);
  switch (status & 0xFF) {
    case SQLITE_NOTADB:
      throw InputError(file, "", "is not the store of a study");
    case SQLITE_CORRUPT:
      throw damagedStore(file_, reason);
    case SQLITE_FULL:
      throw TextError(
          "cannot be written, the disk is full; what is done stays, and the same "
          "command goes on when there is room",
          {printable(file)});
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw TextError("is in use by another process; a shard belongs to one process at a time",
                      {printable(file)});
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
    case SQLITE_READONLY:
      throw InputError(file, "", message("cannot be opened: {}", Message::name(reason)));
    default:
      throw TextError(message("cannot be written: {}; what is done stays, and the same command "
                              "goes on afterwards",
                              Message::name(reason)),
                      {printable(file)});
  }
}

void StudyDatabase::execute(const char* sql) const {
  const int status = sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr);
  if (status == SQLITE_OK) return;
  try {
    fail(status);  // before the transaction ends, which has a message of its own
  } catch (...) {
    rollBack();
    throw;
  }
}

void StudyDatabase::rollBack() const {
  sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

std::int64_t StudyDatabase::number(const char* sql) const {
  Statement statement(*this, sql);
  return statement.step() ? statement.whole(0) : 0;
}

void StudyDatabase::endSharing() const {
  sqlite3_busy_timeout(connection_.get(), 0);
  sqlite3_exec(connection_.get(), "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
  sqlite3_busy_timeout(connection_.get(), kLockPatience);
}

StudyDatabase::Statement::Statement(const StudyDatabase& database, const char* sql)
    : database_(database) {
  check(sqlite3_prepare_v2(database.connection_.get(), sql, -1, &statement_, nullptr));
}

StudyDatabase::Statement::~Statement() {
  sqlite3_finalize(statement_);
}

void StudyDatabase::Statement::bind(int index, std::int64_t value) {
  check(sqlite3_bind_int64(statement_, index, value));
}

void StudyDatabase::Statement::bind(int index, double value) {
  check(sqlite3_bind_double(statement_, index, value));
}

void StudyDatabase::Statement::bindText(int index, std::string_view text) {
  check(
      sqlite3_bind_text64(statement_, index, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void StudyDatabase::Statement::bindBytes(int index, std::string_view bytes) {
  check(sqlite3_bind_blob64(statement_, index, bytes.data(), bytes.size(), SQLITE_STATIC));
}

bool StudyDatabase::Statement::step() {
  const int status = sqlite3_step(statement_);
  if (status != SQLITE_ROW && status != SQLITE_DONE) database_.fail(status);
  return status == SQLITE_ROW;
}

void StudyDatabase::Statement::reset() {
  sqlite3_reset(statement_);
}

std::int64_t StudyDatabase::Statement::whole(int column) const {
  return sqlite3_column_int64(statement_, column);
}

double StudyDatabase::Statement::real(int column) const {
  return sqlite3_column_double(statement_, column);
}

std::string StudyDatabase::Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return text
             ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
             : std::string();
}

std::vector<double> StudyDatabase::Statement::numbers(int column) const {
  const void* bytes = sqlite3_column_blob(statement_, column);
  std::vector<double> values(static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)) /
                             sizeof(double));
  if (bytes) std::memcpy(values.data(), bytes, values.size() * sizeof(double));
  return values;
}

void StudyDatabase::Statement::check(int status) const {
  if (status != SQLITE_OK) database_.fail(status);
}

}  // namespace asperity
