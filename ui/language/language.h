// The language of the texts that users see: English, or one of resources/translations. One thread
// chooses it, any thread may read it at any time; texts made earlier do not change. Tables, scene
// files and lines on stderr are always in English.
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

class QObject;

namespace asperity {

inline QString fromUtf8(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

struct Language {
  std::string_view code;  // "de"
  std::string_view name;  // in the language itself: "Deutsch"
};

/// Returns all languages; English first.
std::span<const Language> languages();

/// Returns "en, de".
std::string languageCodes();

/// Returns the code of an available language: "de" for "de", "de_AT" or "de-CH"; empty for others.
std::string_view languageFor(std::string_view locale);

/// Chooses one of `languages()`; an unknown code means English. If there is a QCoreApplication, its
/// tr() and the texts of Qt's own dialogs follow, and every widget gets a QEvent::LanguageChange.
void useLanguage(std::string_view code);

/// Calls `setTexts` now, and again whenever the language changes: `setTexts` sets all texts of the
/// widget that come from tr(). A child of a widget is allowed, too. GUI thread.
void keepTranslated(QObject& widget, std::function<void()> setTexts);

/// Returns the code of the current language.
std::string_view presentLanguage();

/// Returns the translation of a source text in one of the contexts of resources/translations;
/// nothing in English, or where there is none.
std::optional<QString> translationIn(const char* context, const char* english);

/// A text that follows the language: it is made each time that it is asked for. For texts that may
/// be on the screen when the language changes.
class LiveText {
 public:
  LiveText() = default;
  template <class Make>
  requires std::is_invocable_r_v<QString, Make> LiveText(Make make) : make_(std::move(make)) {}

  bool isEmpty() const { return !make_; }
  operator QString() const { return make_ ? make_() : QString(); }

 private:
  std::function<QString()> make_;
};

/// The texts of pictures and commands.
class Words {
 public:
  /// Returns the translation in UTF-8. Qt's tool for translators finds its calls like any tr().
  static std::string tr(const char* english);
};

/// Returns "0.5" as the language writes it: "0,5". The text may have points only in numbers. Such a
/// number can be typed.
std::string inLanguage(std::string number);
QString inLanguage(QString number);

/// Returns a printed number, which may have a unit, as pictures and readings show it: "12300.5 s"
/// as "12,300.5 s" or "12.300,5 s".
std::string readingInLanguage(std::string number);

}  // namespace asperity
