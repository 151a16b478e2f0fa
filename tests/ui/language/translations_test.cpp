// Whether German has every text: those of core, made by asking for them, and those of the sources,
// as Qt's own tool finds them.
#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>

#include "tests/ui/language/core_texts.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

const QString kFolder = ASPERITY_RESOURCES_DIR "/translations/";

/// Translations by context and source; unfinished ones are empty.
using Messages = std::map<std::pair<QString, QString>, QString>;

Messages messagesOf(const QString& path) {
  Messages messages;
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  QXmlStreamReader xml(&file);
  QString context, source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == u"name") context = xml.readElementText();
    if (xml.name() == u"source") source = xml.readElementText();
    if (xml.name() != u"translation") continue;
    const bool isDone = !xml.attributes().hasAttribute("type");
    const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    const bool isNew = messages.insert({{context, source}, isDone ? text : QString()}).second;
    EXPECT_TRUE(isNew) << "stands twice: " << source.toStdString();
  }
  EXPECT_FALSE(xml.hasError()) << path.toStdString() << xml.errorString().toStdString();
  return messages;
}

QStringList placesIn(const QString& text) {
  static const QRegularExpression place(QStringLiteral("%\\d+|%n|%p"));
  QStringList places;
  for (auto it = place.globalMatch(text); it.hasNext();) places += it.next().captured();
  places.sort();
  places.removeDuplicates();  // forms of the plural stand side by side
  return places;
}

class German : public testing::Test {
 protected:
  German() { useLanguage("de"); }
  ~German() override { useLanguage("en"); }

  /// Those that have no translation, one a line.
  static std::string missing(const std::set<Message>& texts) {
    EXPECT_GT(texts.size(), 20U);
    std::string lines;
    for (const Message& text : texts)
      if (!findTranslation(text)) lines += text.english() + "\n";
    return lines;
  }
};

TEST_F(German, HasTheTableOfParameters) {
  EXPECT_EQ(missing(tableTexts()), "");
  EXPECT_EQ(missing(explanationTexts()), "");
}

TEST_F(German, HasTheShippedScenes) {
  EXPECT_EQ(missing(sceneTexts()), "");
  for (const Message& text : sceneTexts()) EXPECT_TRUE(isTranslatedScene(text.text)) << text.text;
}

TEST_F(German, HasThePlans) {
  EXPECT_EQ(missing(planTexts()), "");
}

TEST_F(German, HasTheRefusalsOfValues) {
  EXPECT_EQ(missing(refusalTexts()), "");
}

TEST_F(German, HasTheComplaintsAboutScenesAndProfiles) {
  EXPECT_EQ(missing(complaintTexts()), "");
}

/// Numbers are printed in one style wherever a text of core is shown: never "1e-10".
std::string numbersOfComputers(const std::set<Message>& texts) {
  static const QRegularExpression machine(QStringLiteral("(?<![\\w.,])\\d[\\d.,]*e[-+]?\\d"));
  std::string lines;
  for (const char* code : {"en", "de"}) {
    useLanguage(code);
    for (const Message& message : texts) {
      const std::string text = message.english();
      // What somebody typed is quoted as it was typed.
      if (text.find('\'') != text.npos || text.starts_with("1e999")) continue;
      const QString shown = translatedText(message);
      if (machine.match(shown).hasMatch()) lines += shown.toStdString() + "\n";
    }
  }
  return lines;
}

/// The texts of figures and diagrams, which take seconds to compute, are checked in both ways at
/// once; all others in ShowNoNumberAsComputersWriteIt.
TEST_F(German, HasTheFiguresAndTheirClaims) {
  const std::set<Message> texts = figureTexts();
  EXPECT_EQ(missing(texts), "");
  EXPECT_EQ(numbersOfComputers(texts), "");
}

TEST_F(German, HasTheDiagrams) {
  const std::set<Message> texts = diagramTexts();
  EXPECT_EQ(missing(texts), "");
  EXPECT_EQ(numbersOfComputers(texts), "");
}

/// The templates of a source file: the texts of message("..."), with %1, %2, ... for their places.
QStringList templatesIn(const QString& source) {
  static const QRegularExpression call(
      QStringLiteral(R"re(\bmessage\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+))re"));
  static const QRegularExpression literal(QStringLiteral(R"re("((?:[^"\\]|\\.)*)")re"));
  QStringList templates;
  for (auto it = call.globalMatch(source); it.hasNext();) {
    QByteArray json = "[\"";
    for (auto part = literal.globalMatch(it.next().captured(1)); part.hasNext();)
      json += part.next().captured(1).replace("\\'", "'").toUtf8();
    const QJsonArray one = QJsonDocument::fromJson(json + "\"]").array();
    EXPECT_EQ(one.size(), 1) << json.toStdString();
    const QByteArray text = one.at(0).toString().toUtf8();
    templates += QString::fromStdString(
        detail::Placeholders({text.data(), static_cast<std::size_t>(text.size())}).form);
  }
  return templates;
}

/// Those that no test asks for, too.
TEST_F(German, HasEveryTemplateOfTheSources) {
  std::string lines;
  int count = 0;
  for (const char* layer : {"core", "ui"}) {
    QDirIterator files(QStringLiteral(ASPERITY_SOURCE_DIR "/") + layer, {"*.cpp", "*.h"},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      ASSERT_TRUE(file.open(QIODevice::ReadOnly));
      for (const QString& text : templatesIn(QString::fromUtf8(file.readAll()))) {
        ++count;
        if (!findTranslation(text.toStdString())) lines += text.toStdString() + "\n";
      }
    }
  }
  EXPECT_GT(count, 100);
  EXPECT_EQ(lines, "");
}

TEST(Translations, ShowNoNumberAsComputersWriteIt) {
  for (const auto& texts : {tableTexts(), explanationTexts(), sceneTexts(), planTexts(),
                            refusalTexts(), complaintTexts()})
    EXPECT_EQ(numbersOfComputers(texts), "");
  useLanguage("en");
}

TEST(Translations, AreFinishedAndKeepThePlacesOfValues) {
  for (const char* name : {"asperity_de.ts", "core_de.ts"}) {
    const Messages messages = messagesOf(kFolder + name);
    EXPECT_FALSE(messages.empty()) << name;
    for (const auto& [key, translation] : messages) {
      EXPECT_FALSE(translation.isEmpty()) << key.second.toStdString();
      EXPECT_EQ(placesIn(key.second), placesIn(translation)) << key.second.toStdString();
    }
  }
}

TEST(Translations, HaveEveryTextOfTheSources) {
  const QString tool = ASPERITY_LUPDATE;
  if (tool.isEmpty()) GTEST_SKIP() << "lupdate (Debian: qt6-l10n-tools) is not installed";
  const QTemporaryDir folder;
  const QString found = folder.filePath("found.ts");
  QProcess process;
  process.setWorkingDirectory(ASPERITY_SOURCE_DIR);
  process.start(tool, {"-silent", "-I", ".", "ui", "app", "-ts", found});
  ASSERT_TRUE(process.waitForFinished(60000));
  ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
  const Messages messages = messagesOf(kFolder + "asperity_de.ts");
  const Messages sources = messagesOf(found);
  EXPECT_GT(sources.size(), 100U);
  for (const auto& [key, text] : sources)
    EXPECT_TRUE(key.first == "Words" || key.first.startsWith("asperity::"))
        << "a tr() outside of a class is found in no context: " << key.second.toStdString();
  for (const auto& [key, text] : sources)
    EXPECT_TRUE(messages.contains(key))
        << "not in asperity_de.ts: " << key.first.toStdString() << ": " << key.second.toStdString();
  for (const auto& [key, text] : messages)
    EXPECT_TRUE(sources.contains(key)) << "no longer shown: " << key.second.toStdString();
}

}  // namespace
}  // namespace asperity
