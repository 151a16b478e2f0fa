#include "ui/draw/xml_text.h"

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

std::string xmpPacket(const std::string& title, const std::string& description) {
  std::string packet =
      "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
      "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description rdf:about=\"\" "
      "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n";
  const auto add = [&](const std::string& name, const std::string& text) {
    if (text.empty()) return;
    packet += "<dc:" + name + "><rdf:Alt><rdf:li xml:lang=\"x-default\">" + xmlText(text) +
              "</rdf:li></rdf:Alt></dc:" + name + ">\n";
  };
  add("title", title);
  add("description", description);
  return packet + "</rdf:Description></rdf:RDF></x:xmpmeta>\n<?xpacket end=\"w\"?>";
}

}  // namespace asperity
