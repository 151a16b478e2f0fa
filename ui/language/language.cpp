#include "ui/language/language.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <memory>

#include "core/base/number_text.h"

// This function is outside of the namespace, as the resource compiler's function is.
static void openResources() {
  Q_INIT_RESOURCE(asperity_translations);
}

namespace asperity {
namespace {

constexpr std::array<Language, 2> kLanguages{{{"en", "English"}, {"de", "Deutsch"}}};

/// A loaded language. It is never removed, because other threads may be reading it.
struct Loaded {
  std::string_view code = "en";
  std::unique_ptr<QTranslator> texts, dialogs;  // the program's and Qt's own; none for English
  QLocale locale = QLocale::c();
  bool hasComma = false;  // decimal sign
};

std::atomic<const Loaded*>& presentOne() {
  static const Loaded english;
  static std::atomic<const Loaded*> present{&english};
  return present;
}

const Loaded& present() {
  return *presentOne().load();
}

std::unique_ptr<QTranslator> loaded(const QString& name, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  return translator->load(name, folder) ? std::move(translator) : nullptr;
}

std::unique_ptr<Loaded> load(std::string_view code) {
  auto language = std::make_unique<Loaded>();
  language->code = code;
  if (code == "en") return language;
  const QString name = fromUtf8(code);
  openResources();
  language->texts = loaded("asperity_" + name, QStringLiteral(":/asperity/translations"));
  language->dialogs = loaded("qtbase_" + name, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  language->locale = QLocale(name);
  language->hasComma = language->locale.decimalPoint() == QStringLiteral(",");
  return language;
}

/// Returns one of kLanguages. Only the thread that chooses languages may call it.
const Loaded& loadedLanguage(std::string_view code) {
  static std::map<std::string_view, std::unique_ptr<Loaded>> all;
  std::unique_ptr<Loaded>& language = all[code];
  if (!language) language = load(code);
  return *language;
}

/// Sets the texts of its owner when the language changes.
class Translating : public QObject {
 public:
  Translating(QObject& owner, std::function<void()> setTexts)
      : QObject(&owner), setTexts_(std::move(setTexts)) {
    owner.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LanguageChange) setTexts_();
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> setTexts_;
};

}  // namespace

std::span<const Language> languages() {
  return kLanguages;
}

std::string languageCodes() {
  std::string codes;
  for (const Language& language : kLanguages)
    codes += (codes.empty() ? "" : ", ") + std::string(language.code);
  return codes;
}

std::string_view languageFor(std::string_view locale) {
  const std::string_view code = locale.substr(0, locale.find_first_of("_-.@"));
  const auto found = std::ranges::find(kLanguages, code, &Language::code);
  return found == kLanguages.end() ? std::string_view{} : found->code;
}

void useLanguage(std::string_view code) {
  const std::string_view known = languageFor(code);
  const Loaded& next = loadedLanguage(known.empty() ? kLanguages.front().code : known);
  const Loaded& last = *presentOne().exchange(&next);
  QLocale::setDefault(next.locale);
  if (!QCoreApplication::instance()) return;
  for (const auto* translator : {&last.dialogs, &last.texts})
    if (*translator) QCoreApplication::removeTranslator(translator->get());
  for (const auto* translator : {&next.dialogs, &next.texts})
    if (*translator) QCoreApplication::installTranslator(translator->get());
}

void keepTranslated(QObject& widget, std::function<void()> setTexts) {
  setTexts();
  new Translating(widget, std::move(setTexts));
}

std::string_view presentLanguage() {
  return present().code;
}

std::optional<QString> translationIn(const char* context, const char* english) {
  const QTranslator* texts = present().texts.get();
  if (!texts) return {};
  const QString found = texts->translate(context, english);
  return found.isEmpty() ? std::nullopt : std::optional(found);
}

std::string Words::tr(const char* english) {
  // Qt's tool finds the namespace in most places, but not in all.
  for (const char* context : {"asperity::Words", "Words"})
    if (const auto found = translationIn(context, english)) return found->toStdString();
  return english;
}

std::string inLanguage(std::string number) {
  if (present().hasComma) std::ranges::replace(number, '.', ',');
  return number;
}

QString inLanguage(QString number) {
  return present().hasComma ? number.replace('.', ',') : number;
}

std::string readingInLanguage(std::string number) {
  number = inLanguage(std::move(number));
  const std::size_t begin = number.starts_with(kMinusSign) ? kMinusSign.size() : 0;
  const std::size_t end = std::min(number.find_first_not_of("0123456789", begin), number.size());
  const char* separator = present().hasComma ? "." : ",";
  for (std::size_t at = end; at > begin + 3;) number.insert(at -= 3, separator);
  return number;
}

}  // namespace asperity
