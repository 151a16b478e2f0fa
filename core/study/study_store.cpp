#include "core/study/study_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text_encoding.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little,
              "the numbers of a store are little-endian");

constexpr int kApplication = 0x41737031;  // "Asp1", in the header of the file
constexpr int kSchema = 1;                // of the tables
constexpr int kLockPatience = 60000;      // ms to wait for another process

constexpr const char* kTables = R"(
CREATE TABLE IF NOT EXISTS meta (key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS chunks (
  number INTEGER PRIMARY KEY,
  first INTEGER NOT NULL, count INTEGER NOT NULL,
  seconds REAL NOT NULL,
  failures TEXT NOT NULL,
  digest TEXT NOT NULL,
  numbers BLOB NOT NULL);
)";

std::string failuresText(const StudyChunk& chunk) {
  if (chunk.failures.empty()) return "";
  Json list = Json::array();
  for (const StudyFailure& failure : chunk.failures)
    list.push_back({failure.simulation, failure.message});
  return jsonLine(list);
}

std::string_view asBytes(const std::vector<double>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

/// Returns the digest of a chunk without the time that it took: SQLite does not notice changed
/// bytes inside a column.
std::string chunkDigest(const StudyChunk& chunk, const std::string& failures) {
  std::string bytes =
      fmt::format("{} {} {} {}\n", chunk.number, chunk.first, chunk.count, failures);
  bytes += asBytes(chunk.values);
  return sha256(bytes);
}

Message shardWords(const Shard& shard) {
  return shard.isWhole() ? Message("the whole study")
                         : message("shard {}/{}", shard.number, shard.count);
}

/// Returns the file in which processes claim the chunks of a store.
fs::path claimsFile(const fs::path& file) {
  fs::path claims = file;
  claims += "-claims";
  return claims;
}

}  // namespace

Shard parseShard(const std::string& text) {
  constexpr std::int64_t kMostShards = 1000000;
  Shard shard;
  const std::size_t stroke = text.find('/');
  if (stroke == text.npos || !readNumber(std::string_view(text).substr(0, stroke), shard.number) ||
      !readNumber(std::string_view(text).substr(stroke + 1), shard.count))
    throw InputError("", "--shard", message("'{}' is not I/N, such as 3/8", shortened(text)));
  if (shard.count < 1 || shard.count > kMostShards || shard.number < 1 ||
      shard.number > shard.count)
    throw InputError(
        "", "--shard",
        message("{} is outside 1/N to N/N, with N from 1 to {}", shortened(text), kMostShards));
  return shard;
}

/// A prepared statement.
class StudyStore::Statement {
 public:
  Statement(const StudyStore& store, const char* sql) : store_(store) {
    const int status = sqlite3_prepare_v2(store.connection_.get(), sql, -1, &statement_, nullptr);
    if (status != SQLITE_OK) store.fail(status);
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(int index, std::int64_t value) { check(sqlite3_bind_int64(statement_, index, value)); }
  void bind(int index, double value) { check(sqlite3_bind_double(statement_, index, value)); }
  /// The bytes must remain valid until the statement has run.
  void bindText(int index, std::string_view text) {
    check(sqlite3_bind_text64(statement_, index, text.data(), text.size(), SQLITE_STATIC,
                              SQLITE_UTF8));
  }
  void bindBytes(int index, std::string_view bytes) {
    check(sqlite3_bind_blob64(statement_, index, bytes.data(), bytes.size(), SQLITE_STATIC));
  }

  /// Returns whether there is a row.
  bool step() {
    const int status = sqlite3_step(statement_);
    if (status != SQLITE_ROW && status != SQLITE_DONE) store_.fail(status);
    return status == SQLITE_ROW;
  }
  void reset() { sqlite3_reset(statement_); }
  std::int64_t whole(int column) const { return sqlite3_column_int64(statement_, column); }
  double real(int column) const { return sqlite3_column_double(statement_, column); }
  std::string text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return text ? std::string(text,
                              static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
                : std::string();
  }
  std::vector<double> numbers(int column) const {
    const void* bytes = sqlite3_column_blob(statement_, column);
    std::vector<double> values(static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)) /
                               sizeof(double));
    if (bytes) std::memcpy(values.data(), bytes, values.size() * sizeof(double));
    return values;
  }

 private:
  void check(int status) const {
    if (status != SQLITE_OK) store_.fail(status);
  }

  const StudyStore& store_;
  sqlite3_stmt* statement_ = nullptr;
};

void StudyStore::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

bool isStudyStore(std::string_view beginning) {
  constexpr std::size_t kPlace = 68, kBytes = 4;  // of application_id, its highest byte first
  if (beginning.size() < kPlace + kBytes || !beginning.starts_with("SQLite format 3")) return false;
  std::uint32_t application = 0;
  for (const char byte : beginning.substr(kPlace, kBytes))
    application = application << 8 | static_cast<unsigned char>(byte);
  return application == kApplication;
}

StudyStore::StudyStore(const fs::path& file, const ParameterStudy& study, const Shard& shard)
    : file_(file) {
  checkWritable(file);
  shard_ = shard;
  open(Access::Write);
  if (!hasTables()) create(study, shard);
  readHeader();
  if (study_->digest != study.digest)
    throw InputError(file_.string(), "",
                     message("is the store of another study: {}; another store is needed",
                             describeDifference(study_->canonical, study.canonical)));
  if (!(shard_ == shard))
    throw InputError(
        file_.string(), "--shard",
        message("the store is of {}, not of {}", shardWords(shard_), shardWords(shard)));
  // The study of the caller has its folder.
  study_ = std::make_shared<ParameterStudy>(study);
}

StudyStore::StudyStore(const fs::path& file) : file_(file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) throw InputError(file.string(), "", "is not there");
  if (fs::is_directory(file, ignored)) throw InputError(file.string(), "", "is a folder");
  open(Access::Read);
  if (!hasTables()) throw InputError(file.string(), "", "is empty; 'asperity study run' fills it");
  readHeader();
}

StudyStore::~StudyStore() {
  if (claims_ >= 0) ::close(claims_);
}

StudyStore::StudyStore(StudyStore&& other) noexcept
    : file_(std::move(other.file_)),
      connection_(std::move(other.connection_)),
      study_(std::move(other.study_)),
      shard_(other.shard_),
      access_(other.access_),
      claims_(std::exchange(other.claims_, -1)) {}

void StudyStore::fail(int status) const {
  const std::string file = file_.string();
  const std::string said = connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(status);
  switch (status & 0xFF) {
    case SQLITE_NOTADB:
      throw InputError(file, "", "is not the store of a study");
    case SQLITE_CORRUPT:
      throw InputError(file, "",
                       message("is damaged ({}); the study has to be run into another store, or "
                               "merged from intact ones",
                               Message::name(said)));
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
      throw InputError(file, "", message("cannot be opened: {}", Message::name(said)));
    default:
      throw TextError(message("cannot be written: {}; what is done stays, and the same command "
                              "goes on afterwards",
                              Message::name(said)),
                      {printable(file)});
  }
}

void StudyStore::open(Access access) {
  access_ = access;
  std::error_code error;
  if (fs::exists(file_, error) && fs::file_size(file_, error) > 0) {
    const RegularFile present(file_);
    if (const std::string start = present.read(0, 16); !start.starts_with("SQLite format 3")) {
      const std::string_view kind = detectNonText(start);
      throw InputError(file_.string(), "",
                       kind.empty()
                           ? message("is not the store of a study")
                           : message("is not the store of a study, but {}", Message(kind)));
    }
  }
  const auto attempt = [&](const std::string& name, int flags) {
    sqlite3* connection = nullptr;
    const int status = sqlite3_open_v2(name.c_str(), &connection, flags, nullptr);
    connection_.reset(connection);
    if (status != SQLITE_OK) fail(status);
    sqlite3_extended_result_codes(connection, 1);
    sqlite3_busy_timeout(connection, kLockPatience);
  };
  const int usual = SQLITE_OPEN_NOMUTEX;
  // An absolute name cannot be taken for a URI or for one of SQLite's own names.
  const std::string name = fs::absolute(file_).string();
  if (access == Access::Read) {
    // A killed process leaves changes that only a writer can take over. SQLite falls back to
    // reading where the file is protected.
    attempt(name, usual | SQLITE_OPEN_READWRITE);
    return;
  }
  attempt(name, usual | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (!shard_.isWhole()) execute("PRAGMA locking_mode=EXCLUSIVE");
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

bool StudyStore::hasTables() const {
  return number("SELECT count(*) FROM sqlite_master") > 0;
}

void StudyStore::create(const ParameterStudy& study, const Shard& shard) {
  execute("BEGIN IMMEDIATE");
  execute(kTables);
  execute(fmt::format("PRAGMA application_id={}", kApplication).c_str());
  execute(fmt::format("PRAGMA user_version={}", kSchema).c_str());
  const auto put = [&](const char* key, const std::string& value) {
    Statement statement(*this, "INSERT OR IGNORE INTO meta VALUES (?, ?)");
    statement.bindText(1, key);
    statement.bindText(2, value);
    statement.step();
  };
  // Another process may have made the tables at the same moment; then its values stay.
  put("study", study.canonical);
  put("title", study.title);
  put("shard", fmt::format("{}/{}", shard.number, shard.count));
  put("version", ASPERITY_VERSION);
  execute("COMMIT");
}

void StudyStore::readHeader() {
  const std::int64_t application = number("PRAGMA application_id");
  const std::int64_t schema = number("PRAGMA user_version");
  if (application != kApplication)
    throw InputError(file_.string(), "", "is a database, but not the store of a study");
  if (schema != kSchema)
    throw InputError(
        file_.string(), "",
        message("has schema {}; this program knows {}: a newer one is needed", schema, kSchema));
  const std::string text = metaText("study");
  ParameterStudy study;
  try {
    study = readStudy(text, file_.string(), {});
  } catch (const InputError&) {
    throw InputError(file_.string(), "", "is damaged: its study cannot be read");
  }
  // The stored text is the study, even if a later program would write it differently.
  study.canonical = text;
  study.digest = sha256(text);
  study.title = metaText("title");
  study_ = std::make_shared<ParameterStudy>(std::move(study));
  const std::string shard = metaText("shard");
  shard_ = parseShard(shard);
}

std::string StudyStore::metaText(const char* key) const {
  Statement statement(*this, "SELECT value FROM meta WHERE key = ?");
  statement.bindText(1, key);
  return statement.step() ? statement.text(0) : std::string();
}

void StudyStore::execute(const char* sql) const {
  const int status = sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr);
  if (status == SQLITE_OK) return;
  if (sqlite3_get_autocommit(connection_.get()) == 0 && std::strcmp(sql, "ROLLBACK") != 0) {
    // The message is that of the first error.
    try {
      fail(status);
    } catch (...) {
      sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
      throw;
    }
  }
  fail(status);
}

std::int64_t StudyStore::number(const char* sql) const {
  Statement statement(*this, sql);
  return statement.step() ? statement.whole(0) : 0;
}

std::int64_t StudyStore::chunksWanted() const {
  const std::int64_t all = study_->chunks();
  return all / shard_.count + (all % shard_.count >= shard_.number ? 1 : 0);
}

std::int64_t StudyStore::chunksDone() const {
  return number("SELECT count(*) FROM chunks");
}

std::int64_t StudyStore::simulationsDone() const {
  return number("SELECT coalesce(sum(count), 0) FROM chunks");
}

std::string StudyStore::chunksDigest() const {
  std::string numbers;
  Statement statement(*this, "SELECT number FROM chunks ORDER BY number");
  while (statement.step()) numbers += fmt::format("{},", statement.whole(0));
  return sha256(numbers);
}

double StudyStore::secondsSpent() const {
  Statement statement(*this, "SELECT coalesce(sum(seconds), 0) FROM chunks");
  return statement.step() ? statement.real(0) : 0;
}

bool StudyStore::has(std::int64_t chunk) const {
  Statement statement(*this, "SELECT 1 FROM chunks WHERE number = ?");
  statement.bind(1, chunk);
  return statement.step();
}

bool StudyStore::hasFailures() const {
  return number("SELECT EXISTS (SELECT 1 FROM chunks WHERE failures <> '')") != 0;
}

std::vector<std::int64_t> StudyStore::missing(std::size_t most) const {
  std::vector<std::int64_t> missing;
  std::int64_t next = shard_.number - 1;
  const auto upTo = [&](std::int64_t number) {
    for (; next < number && missing.size() < most; next += shard_.count) missing.push_back(next);
  };
  Statement statement(*this, "SELECT number FROM chunks ORDER BY number");
  while (missing.size() < most && statement.step()) {
    upTo(statement.whole(0));
    next = std::max(next, statement.whole(0) + shard_.count);
  }
  upTo(study_->chunks());
  return missing;
}

std::int64_t StudyStore::claim(std::int64_t from) {
  if (claims_ < 0 && shard_.isWhole()) {
    claims_ = ::open(claimsFile(file_).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (claims_ < 0)
      throw TextError(message("cannot be opened: {}", Message(std::strerror(errno))),
                      {printable(claimsFile(file_).string())});
  }
  Statement statement(*this, "SELECT number FROM chunks WHERE number >= ? ORDER BY number");
  std::int64_t next = from;
  while (next % shard_.count != shard_.number - 1) ++next;
  statement.bind(1, next);
  bool hasRow = statement.step();
  for (; next < study_->chunks(); next += shard_.count) {
    while (hasRow && statement.whole(0) < next) hasRow = statement.step();
    if (hasRow && statement.whole(0) == next) continue;
    if (claims_ < 0) return next;
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = next;
    lock.l_len = 1;
    if (::fcntl(claims_, F_OFD_SETLK, &lock) != 0) {
      if (errno == EAGAIN || errno == EACCES) continue;  // another process works on it
      throw TextError(message("cannot be locked: {}", Message(std::strerror(errno))),
                      {printable(claimsFile(file_).string())});
    }
    // Another process may have finished it since the query above.
    if (!has(next)) return next;
  }
  return -1;
}

void StudyStore::insert(const StudyChunk& chunk) {
  const std::string failures = failuresText(chunk), digest = chunkDigest(chunk, failures);
  Statement statement(*this, "INSERT OR IGNORE INTO chunks VALUES (?, ?, ?, ?, ?, ?, ?)");
  statement.bind(1, chunk.number);
  statement.bind(2, chunk.first);
  statement.bind(3, chunk.count);
  statement.bind(4, chunk.seconds);
  statement.bindText(5, failures);
  statement.bindText(6, digest);
  statement.bindBytes(7, asBytes(chunk.values));
  statement.step();
}

void StudyStore::add(const StudyChunk& chunk) {
  add(std::vector<StudyChunk>{chunk});
}

void StudyStore::add(const std::vector<StudyChunk>& chunks) {
  execute("BEGIN IMMEDIATE");
  try {
    for (const StudyChunk& chunk : chunks) insert(chunk);
    execute("COMMIT");
  } catch (...) {
    sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

void StudyStore::addEqual(const std::vector<StudyChunk>& chunks, const fs::path& from) {
  Statement present(*this, "SELECT digest FROM chunks WHERE number = ?");
  for (const StudyChunk& chunk : chunks) {
    present.bind(1, chunk.number);
    if (present.step() && present.text(0) != chunkDigest(chunk, failuresText(chunk)))
      throw InputError(
          from.string(), "",
          message("has other results of chunk {} than the stores before it", chunk.number));
    present.reset();
  }
  add(chunks);
}

void StudyStore::finish() {
  // While another process has the store open, the last one does this.
  sqlite3_busy_timeout(connection_.get(), 0);
  sqlite3_exec(connection_.get(), "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
  sqlite3_busy_timeout(connection_.get(), kLockPatience);
  if (shard_.isWhole() && claims_ >= 0) ::unlink(claimsFile(file_).c_str());
}

void StudyStore::eachChunk(const std::function<bool(const StudyChunk&)>& use) const {
  const std::size_t numbers = study_->numbers();
  Statement statement(*this,
                      "SELECT number, first, count, seconds, failures, digest, numbers FROM chunks "
                      "ORDER BY number");
  StudyChunk chunk;
  while (statement.step()) {
    chunk.number = statement.whole(0);
    chunk.first = statement.whole(1);
    chunk.count = statement.whole(2);
    chunk.seconds = statement.real(3);
    chunk.values = statement.numbers(6);
    chunk.failures.clear();
    const std::string failures = statement.text(4);
    const bool isInStudy = chunk.number >= 0 && chunk.number < study_->chunks();
    if (!isInStudy || chunk.first != chunk.number * study_->chunk ||
        chunk.count != study_->sizeOfChunk(chunk.number) ||
        chunk.values.size() != numbers * static_cast<std::size_t>(chunk.count) ||
        chunkDigest(chunk, failures) != statement.text(5))
      throw InputError(file_.string(), "",
                       message("is damaged: chunk {} is not what was written; the study has to be "
                               "run into another store, or merged from intact ones",
                               chunk.number));
    if (!failures.empty())
      for (const Json& one : jsonValue(failures))
        chunk.failures.push_back({one[0].get<std::int64_t>(), one[1].get<std::string>()});
    if (!use(chunk)) return;
  }
}

void StudyStore::check() const {
  Statement statement(*this, "PRAGMA quick_check(1)");
  const std::string said = statement.step() ? statement.text(0) : "no answer";
  if (said != "ok")
    throw InputError(file_.string(), "",
                     message("is damaged ({}); the study has to be run into another store, or "
                             "merged from intact ones",
                             Message::name(said)));
}

}  // namespace asperity
