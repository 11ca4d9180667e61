// Any bytes as SDF, up to where libsdformat would read them: encodings, includes, places, values
// and the account.

#include <cstdlib>

#include "core/document/xml_document.h"
#include "core/kinematics/sdf_reader.h"
#include "core/report/account.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Findings findings;
  {
    FaultList faults(findings, "fuzz.sdf");
    std::string problem;
    std::string text = xmlAsUtf8(textOf(std::as_bytes(std::span(data, size))), problem);
    require(problem.empty() || text.empty());
    const auto kept = sdfWithoutIncludes(text, faults);
    require(!kept || kept->size() == text.size());
    if (kept) {
      for (const std::string& name : sdfMeshes(*kept)) require(!name.empty());
      const auto document =
          XmlDocument::parse(*kept, 100'000, {"sdf.invalid", "sdf.invalid"}, faults);
      require(document != nullptr || !findings.empty());
      if (document) {
        const bool sound = judgeSdf(*document, faults);
        require(sound || countOf(findings, Severity::error) > 0);
      }
    }
  }
  const Account account = accountOf(findings);
  require(account.total() >= account.leftOut().size());
  for (const Finding& fault : findings) require(!fault.print().empty());
  return 0;
}
