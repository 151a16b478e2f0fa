#include "ui/picture/pdf_file.h"

#include "core/scene/atomic_file.h"

namespace asperity {

std::string pdfOf(const DrawList&, const PdfOptions&) {
  return {};
}

void writePdf(const std::filesystem::path& path, const DrawList& list, const PdfOptions& options) {
  writeFileAtomically(path, pdfOf(list, options));
}

}  // namespace asperity
