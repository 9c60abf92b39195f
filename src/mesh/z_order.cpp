#include "mesh/z_order.h"

#include "base/radix_sort.h"

namespace inkedge::mesh {

void sortByKey(std::vector<ZOrderKey>& keys) {
    base::radixSort(keys, [](const ZOrderKey& key) { return key.key; });
}

}  // namespace inkedge::mesh
