#include "app/mpi/partition.h"

#include <petscmat.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace wend {
namespace {

/// PETSc frees it with the object that it is given to.
PetscInt* copyForPetsc(const std::vector<int>& list) {
    PetscInt* copy = nullptr;
    if (PetscMalloc1(list.size() + 1, &copy) != 0) throw std::bad_alloc();
    std::copy(list.begin(), list.end(), copy);
    return copy;
}

PetscErrorCode partition(const WeightedGraph& graph, int parts, std::vector<int>& partOf) {
    const PetscInt nodes = graph.nodes();
    ::Mat adjacency = nullptr;
    PetscCall(MatCreateMPIAdj(PETSC_COMM_SELF, nodes, nodes, copyForPetsc(graph.start),
                              copyForPetsc(graph.neighbour), copyForPetsc(graph.edgeWeight), &adjacency));
    MatPartitioning partitioning = nullptr;
    PetscCall(MatPartitioningCreate(PETSC_COMM_SELF, &partitioning));
    PetscCall(MatPartitioningSetAdjacency(partitioning, adjacency));
    PetscCall(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
    PetscCall(MatPartitioningSetVertexWeights(partitioning, copyForPetsc(graph.nodeWeight)));
    PetscCall(MatPartitioningSetUseEdgeWeights(partitioning, PETSC_TRUE));
    PetscCall(MatPartitioningSetNParts(partitioning, parts));
    IS result = nullptr;
    PetscCall(MatPartitioningApply(partitioning, &result));
    const PetscInt* indices = nullptr;
    PetscCall(ISGetIndices(result, &indices));
    partOf.assign(indices, indices + nodes);
    PetscCall(ISRestoreIndices(result, &indices));
    PetscCall(ISDestroy(&result));
    PetscCall(MatPartitioningDestroy(&partitioning));
    PetscCall(MatDestroy(&adjacency));
    return 0;
}

}  // namespace

std::vector<int> partitionOf(const WeightedGraph& graph, int parts) {
    std::vector<int> partOf(graph.nodeWeight.size(), 0);
    if (parts == 1 || graph.nodes() <= parts) {
        for (std::size_t i = 0; i < partOf.size(); ++i) partOf[i] = static_cast<int>(i) % parts;
        return partOf;
    }
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    const PetscErrorCode code = partition(graph, parts, partOf);
    PetscPopErrorHandler();
    if (code != 0)
        throw std::runtime_error("the mesh cannot be divided: PETSc reports error " + std::to_string(code));
    return partOf;
}

}  // namespace wend
