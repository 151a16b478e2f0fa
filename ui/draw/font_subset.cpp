#include "ui/draw/font_subset.h"

#include <hb-subset.h>
#include <hb.h>

#include <QFile>
#include <QString>
#include <memory>
#include <stdexcept>

/// Outside any namespace, as Qt asks: makes the embedded files known where this is a static
/// library.
static void initFontResources() {
  Q_INIT_RESOURCE(fonts);
}

namespace asperity {
namespace {

template <auto destroy>
struct Destroyer {
  template <typename T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using Blob = std::unique_ptr<hb_blob_t, Destroyer<hb_blob_destroy>>;
using Face = std::unique_ptr<hb_face_t, Destroyer<hb_face_destroy>>;
using SubsetInput = std::unique_ptr<hb_subset_input_t, Destroyer<hb_subset_input_destroy>>;

Face faceOf(const QByteArray& file) {
  const Blob blob(hb_blob_create(file.constData(), static_cast<unsigned>(file.size()),
                                 HB_MEMORY_MODE_READONLY, nullptr, nullptr));
  return Face(hb_face_create(blob.get(), 0));
}

}  // namespace

QByteArray fontFile(bool bold) {
  initFontResources();
  QFile file(bold ? QStringLiteral(":/asperity/fonts/DejaVuSans-Bold.ttf")
                  : QStringLiteral(":/asperity/fonts/DejaVuSans.ttf"));
  if (!file.open(QIODevice::ReadOnly))
    throw std::runtime_error("The embedded font " + file.fileName().toStdString() +
                             " cannot be read.");
  return file.readAll();
}

std::set<char32_t> charactersIn(const DrawList& list, bool bold) {
  std::set<char32_t> characters;
  for (const DrawText& text : list.texts)
    if (text.bold == bold)
      for (const char32_t character : QString::fromStdString(text.utf8).toUcs4())
        characters.insert(character);
  return characters;
}

QByteArray fontSubset(bool bold, const std::set<char32_t>& characters) {
  const QByteArray file = fontFile(bold);
  const Face whole = faceOf(file);
  const SubsetInput input(hb_subset_input_create_or_fail());
  if (!input) throw std::runtime_error("There is no memory to cut the embedded font.");
  hb_set_t* const wanted = hb_subset_input_unicode_set(input.get());
  for (const char32_t character : characters) hb_set_add(wanted, character);
  hb_set_t* const dropped = hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG);
  for (const hb_tag_t table : {HB_TAG('G', 'S', 'U', 'B'), HB_TAG('G', 'P', 'O', 'S'),
                               HB_TAG('G', 'D', 'E', 'F'), HB_TAG('k', 'e', 'r', 'n')})
    hb_set_add(dropped, table);
  hb_subset_input_set_flags(input.get(), HB_SUBSET_FLAGS_NO_HINTING);
  const Face part(hb_subset_or_fail(whole.get(), input.get()));
  if (!part) throw std::runtime_error("The embedded font cannot be cut to the glyphs in use.");
  const Blob bytes(hb_face_reference_blob(part.get()));
  unsigned size = 0;
  const char* const data = hb_blob_get_data(bytes.get(), &size);
  return {data, static_cast<qsizetype>(size)};
}

}  // namespace asperity
