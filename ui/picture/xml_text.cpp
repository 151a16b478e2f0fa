#include "ui/picture/xml_text.h"

#include <QList>
#include <QString>

namespace asperity {
namespace {

bool isXmlCharacter(char32_t c) {
  return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
}

}  // namespace

std::string xmlText(std::string_view utf8) {
  // Qt replaces what is no UTF-8.
  const auto characters =
      QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())).toUcs4();
  QString text;
  for (const char32_t character : characters) {
    const char32_t held = isXmlCharacter(character) ? character : U'\uFFFD';
    text += QString::fromUcs4(&held, 1);
  }
  return text.toHtmlEscaped().toStdString();
}

}  // namespace asperity
