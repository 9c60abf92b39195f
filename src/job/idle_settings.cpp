#include <inkedge/job.h>
#include <inkedge/setting_table.h>

#include "job/file_names.h"
#include "job/output_kinds.h"

namespace inkedge {

std::vector<std::string> idleSettings(const Job& job) {
    const OutputKinds kinds = job::kindsOf(job, job::viewsOf(job));
    return idleSettings(job::withMapsOf(job.outputs, job.settings), kinds);
}

}  // namespace inkedge
