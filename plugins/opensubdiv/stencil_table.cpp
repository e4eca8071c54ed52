#include "stencil_table.h"

#include <limits>

#include "failure.h"

namespace candela_opensubdiv {
void replaceDerivatives(RowSum& row, const RowSum& other) {
    for (Weights& weights : row.values()) weights = {weights.value, 0.0, 0.0};
    for (std::size_t i = 0; i < other.columns().size(); ++i) {
        row.add(other.columns()[i], {0.0, other.values()[i].du, other.values()[i].dv});
    }
}

void StencilTable::add(const RowSum& row) {
    const std::size_t before = entries.size();
    for (std::size_t i = 0; i < row.columns().size(); ++i) {
        const Weights& weights = row.values()[i];
        const WeightEntry entry{static_cast<std::uint32_t>(row.columns()[i]),
                                static_cast<float>(weights.value), static_cast<float>(weights.du),
                                static_cast<float>(weights.dv)};
        if (entry.value != 0.0f || entry.du != 0.0f || entry.dv != 0.0f) entries.push_back(entry);
    }
    lengths.push_back(static_cast<std::uint32_t>(entries.size() - before));
}

WeightTable::WeightTable(std::span<StencilTable* const> parts) {
    std::size_t rows = 0, entries = 0;
    for (const StencilTable* part : parts) {
        rows += part->lengths.size();
        entries += part->entries.size();
    }
    if (entries > std::numeric_limits<std::uint32_t>::max()) {
        throw Failure{"", "the table of weights has " + std::to_string(entries) +
                              " entries, more than 4294967295; it needs a lower level"};
    }
    starts_.reserve(rows + 1);
    columns_.reserve(entries);
    weights_.reserve(entries);
    duWeights_.reserve(entries);
    dvWeights_.reserve(entries);
    for (StencilTable* part : parts) {
        for (const std::uint32_t length : part->lengths) starts_.push_back(starts_.back() + length);
        for (const WeightEntry& entry : part->entries) {
            columns_.push_back(entry.column);
            weights_.push_back(entry.value);
            duWeights_.push_back(entry.du);
            dvWeights_.push_back(entry.dv);
        }
        *part = {};
    }
}

candela_stencil_table WeightTable::view() const {
    return {static_cast<std::uint32_t>(starts_.size() - 1),
            starts_.data(),
            columns_.data(),
            weights_.data(),
            duWeights_.data(),
            dvWeights_.data()};
}

}  // namespace candela_opensubdiv
