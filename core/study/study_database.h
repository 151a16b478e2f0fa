// The SQLite file of a study's store: how it is opened and shared, its statements, and what its
// errors mean to a user.
// Threading: one thread at a time. Failure: InputError for a file that is no such store or is
// damaged; std::runtime_error in one sentence where writing fails.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/input_error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace asperity {

class StudyDatabase {
 public:
  /// Who uses the file: readers, several processes that write, or one process alone, which needs no
  /// memory shared between processes and so works on network file systems.
  enum class Access { Read, Write, WriteAlone };

  StudyDatabase(std::filesystem::path file, Access access);

  const std::filesystem::path& file() const { return file_; }

  /// Runs statements without a result. Inside a transaction an error ends it.
  void execute(const char* sql) const;
  /// Ends a transaction without its changes, where one is open. Cannot fail.
  void rollBack() const;
  /// Returns the first number of the first row; 0 where there is none.
  std::int64_t number(const char* sql) const;

  /// Converts the file to the form that can be read everywhere. While another process has it open,
  /// nothing happens: the last one does this.
  void endSharing() const;

  /// A prepared statement.
  class Statement {
   public:
    Statement(const StudyDatabase& database, const char* sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    void bind(int index, std::int64_t value);
    void bind(int index, double value);
    /// The bytes must remain valid until the statement has run.
    void bindText(int index, std::string_view text);
    void bindBytes(int index, std::string_view bytes);

    /// Returns whether there is a row.
    bool step();
    void reset();
    std::int64_t whole(int column) const;
    double real(int column) const;
    std::string text(int column) const;
    std::vector<double> numbers(int column) const;

   private:
    void check(int status) const;

    const StudyDatabase& database_;
    sqlite3_stmt* statement_ = nullptr;
  };

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };

  [[noreturn]] void fail(int status) const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> connection_;
};

/// Returns the error for a store whose file is damaged.
InputError damagedStore(const std::filesystem::path& file, const std::string& reason);

}  // namespace asperity
