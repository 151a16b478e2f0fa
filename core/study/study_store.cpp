#include "core/study/study_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Statement = StudyDatabase::Statement;

static_assert(std::endian::native == std::endian::little,
              "the numbers of a store are little-endian");

constexpr int kApplication = 0x41737031;  // "Asp1", in the header of the file
constexpr int kTableSchema = 1;           // of the tables

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

StudyDatabase openForWriting(const fs::path& file, const Shard& shard) {
  checkWritable(file);
  using Access = StudyDatabase::Access;
  return StudyDatabase(file, shard.isWhole() ? Access::Write : Access::WriteAlone);
}

StudyDatabase openForReading(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) throw InputError(file.string(), "", "is not there");
  if (fs::is_directory(file, ignored)) throw InputError(file.string(), "", "is a folder");
  return StudyDatabase(file, StudyDatabase::Access::Read);
}

/// Returns the file in which processes claim the chunks of a store.
fs::path claimsFile(const fs::path& file) {
  fs::path claims = file;
  claims += "-claims";
  return claims;
}

}  // namespace

std::int64_t Shard::chunks(const ParameterStudy& study) const {
  const std::int64_t all = study.chunks();
  return all / count + (all % count >= number ? 1 : 0);
}

std::int64_t Shard::simulations(const ParameterStudy& study) const {
  const std::int64_t last = study.chunks() - 1;
  return chunks(study) * study.chunk - (has(last) ? study.chunk - study.sizeOfChunk(last) : 0);
}

Shard parseShard(const std::string& text) {
  constexpr std::int64_t kMaxShards = 1000000;
  Shard shard;
  const std::size_t stroke = text.find('/');
  if (stroke == text.npos || !readNumber(std::string_view(text).substr(0, stroke), shard.number) ||
      !readNumber(std::string_view(text).substr(stroke + 1), shard.count))
    throw InputError("", "--shard", message("'{}' is not I/N, such as 3/8", shortened(text)));
  if (shard.count < 1 || shard.count > kMaxShards || shard.number < 1 || shard.number > shard.count)
    throw InputError(
        "", "--shard",
        message("{} is outside 1/N to N/N, with N from 1 to {}", shortened(text), kMaxShards));
  return shard;
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
    : database_(openForWriting(file, shard)) {
  if (!hasTables()) create(study, shard);
  readHeader();
  if (study_->digest != study.digest)
    throw InputError(file.string(), "",
                     message("is the store of another study: {}; another store is needed",
                             describeDifference(study_->canonical, study.canonical)));
  if (!(shard_ == shard))
    throw InputError(
        file.string(), "--shard",
        message("the store is of {}, not of {}", shardWords(shard_), shardWords(shard)));
  // The study of the caller has its folder.
  study_ = std::make_shared<ParameterStudy>(study);
}

StudyStore::StudyStore(const fs::path& file) : database_(openForReading(file)) {
  if (!hasTables()) throw InputError(file.string(), "", "is empty; 'asperity study run' fills it");
  readHeader();
}

StudyStore::~StudyStore() {
  if (claims_ >= 0) ::close(claims_);
}

StudyStore::StudyStore(StudyStore&& other) noexcept
    : database_(std::move(other.database_)),
      study_(std::move(other.study_)),
      shard_(other.shard_),
      claims_(std::exchange(other.claims_, -1)) {}

bool StudyStore::hasTables() const {
  return database_.number("SELECT count(*) FROM sqlite_master") > 0;
}

void StudyStore::create(const ParameterStudy& study, const Shard& shard) {
  database_.execute("BEGIN IMMEDIATE");
  database_.execute(kTables);
  database_.execute(fmt::format("PRAGMA application_id={}", kApplication).c_str());
  database_.execute(fmt::format("PRAGMA user_version={}", kTableSchema).c_str());
  const auto put = [&](const char* key, const std::string& value) {
    Statement statement(database_, "INSERT OR IGNORE INTO meta VALUES (?, ?)");
    statement.bindText(1, key);
    statement.bindText(2, value);
    statement.step();
  };
  // Another process may have made the tables at the same moment; then its values stay.
  put("study", study.canonical);
  put("title", study.title);
  put("shard", fmt::format("{}/{}", shard.number, shard.count));
  put("version", ASPERITY_VERSION);
  database_.execute("COMMIT");
}

void StudyStore::readHeader() {
  const std::int64_t application = database_.number("PRAGMA application_id");
  const std::int64_t schema = database_.number("PRAGMA user_version");
  if (application != kApplication)
    throw InputError(file().string(), "", "is a database, but not the store of a study");
  if (schema != kTableSchema)
    throw InputError(file().string(), "",
                     message("has schema {}; this program knows {}: a newer one is needed", schema,
                             kTableSchema));
  const std::string text = metaText("study");
  ParameterStudy study;
  try {
    study = readStudy(text, file().string(), {});
  } catch (const InputError&) {
    throw InputError(file().string(), "", "is damaged: its study cannot be read");
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
  Statement statement(database_, "SELECT value FROM meta WHERE key = ?");
  statement.bindText(1, key);
  return statement.step() ? statement.text(0) : std::string();
}

std::int64_t StudyStore::chunksPlanned() const {
  return shard_.chunks(*study_);
}

std::int64_t StudyStore::chunksDone() const {
  return database_.number("SELECT count(*) FROM chunks");
}

std::int64_t StudyStore::simulationsDone() const {
  return database_.number("SELECT coalesce(sum(count), 0) FROM chunks");
}

std::string StudyStore::chunksDigest() const {
  std::string numbers;
  Statement statement(database_, "SELECT number FROM chunks ORDER BY number");
  while (statement.step()) numbers += fmt::format("{},", statement.whole(0));
  return sha256(numbers);
}

double StudyStore::secondsSpent() const {
  Statement statement(database_, "SELECT coalesce(sum(seconds), 0) FROM chunks");
  return statement.step() ? statement.real(0) : 0;
}

bool StudyStore::has(std::int64_t chunk) const {
  Statement statement(database_, "SELECT 1 FROM chunks WHERE number = ?");
  statement.bind(1, chunk);
  return statement.step();
}

bool StudyStore::hasFailures() const {
  return database_.number("SELECT EXISTS (SELECT 1 FROM chunks WHERE failures <> '')") != 0;
}

std::vector<std::int64_t> StudyStore::missing(std::size_t most) const {
  std::vector<std::int64_t> missing;
  std::int64_t next = shard_.number - 1;
  const auto upTo = [&](std::int64_t number) {
    for (; next < number && missing.size() < most; next += shard_.count) missing.push_back(next);
  };
  Statement statement(database_, "SELECT number FROM chunks ORDER BY number");
  while (missing.size() < most && statement.step()) {
    upTo(statement.whole(0));
    next = std::max(next, statement.whole(0) + shard_.count);
  }
  upTo(study_->chunks());
  return missing;
}

std::int64_t StudyStore::claim(std::int64_t from) {
  if (claims_ < 0 && shard_.isWhole()) {
    claims_ = ::open(claimsFile(file()).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (claims_ < 0)
      throw TextError(message("cannot be opened: {}", Message(std::strerror(errno))),
                      {printable(claimsFile(file()).string())});
  }
  Statement statement(database_, "SELECT number FROM chunks WHERE number >= ? ORDER BY number");
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
                      {printable(claimsFile(file()).string())});
    }
    // Another process may have finished it since the query above.
    if (!has(next)) return next;
  }
  return -1;
}

void StudyStore::insert(const StudyChunk& chunk) {
  const std::string failures = failuresText(chunk), digest = chunkDigest(chunk, failures);
  Statement statement(database_, "INSERT OR IGNORE INTO chunks VALUES (?, ?, ?, ?, ?, ?, ?)");
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
  database_.execute("BEGIN IMMEDIATE");
  try {
    for (const StudyChunk& chunk : chunks) insert(chunk);
    database_.execute("COMMIT");
  } catch (...) {
    database_.rollBack();
    throw;
  }
}

void StudyStore::addEqual(const std::vector<StudyChunk>& chunks, const fs::path& from) {
  Statement present(database_, "SELECT digest FROM chunks WHERE number = ?");
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
  database_.endSharing();
  if (shard_.isWhole() && claims_ >= 0) ::unlink(claimsFile(file()).c_str());
}

void StudyStore::eachChunk(const std::function<bool(const StudyChunk&)>& use) const {
  const std::size_t numbers = study_->numbers();
  Statement statement(database_,
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
      throw InputError(file().string(), "",
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
  Statement statement(database_, "PRAGMA quick_check(1)");
  const std::string answer = statement.step() ? statement.text(0) : "no answer";
  if (answer != "ok") throw damagedStore(file(), answer);
}

}  // namespace asperity
