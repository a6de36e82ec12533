#include "tools/mpi/solve/race_bytes.hpp"

namespace asv::tools {

namespace {

template <class Archive, class Order>
void exchange_order(Archive& archive, Order& order) {
    for (auto* text : {&order.problem, &order.planner}) archive(*text);
    for (auto& setting : order.settings) archive(setting);
    archive(order.seed);
    for (auto* seconds : {&order.time_limit, &order.elapsed_before, &order.optimize})
        archive(*seconds);
    archive(order.threads);
    archive(order.reverse);
}

template <class Archive, class Finish>
void exchange_finish(Archive& archive, Finish& finish) {
    archive(finish.status);
    archive(finish.reason);
    archive(finish.failure);
    exchange_statistics(archive, finish.spent);
}

}  // namespace

std::string bytes_of(const RaceOrder& order) {
    Packer packer;
    packer(order.settings.size());
    exchange_order(packer, order);
    return packer.bytes();
}

RaceOrder order_of(std::string_view bytes) {
    Unpacker unpacker(bytes);
    RaceOrder order;
    std::size_t settings = 0;
    unpacker(settings);
    order.settings.resize(settings);
    exchange_order(unpacker, order);
    return order;
}

std::string bytes_of(const RaceFinish& finish) {
    Packer packer;
    exchange_finish(packer, finish);
    return packer.bytes();
}

RaceFinish finish_of(std::string_view bytes) {
    Unpacker unpacker(bytes);
    RaceFinish finish;
    exchange_finish(unpacker, finish);
    return finish;
}

std::string bytes_of(const core::Path& path) {
    Packer packer;
    packer(path.asv_count());
    packer(path.size());
    for (const geometry::Point& point : path.points()) packer(point);
    return packer.bytes();
}

core::Path path_of(std::string_view bytes) {
    Unpacker unpacker(bytes);
    std::size_t asv_count = 0, states = 0;
    unpacker(asv_count);
    unpacker(states);
    core::Path path(asv_count);
    path.reserve(states);
    std::vector<geometry::Point> state(asv_count);
    for (std::size_t i = 0; i < states; ++i) {
        for (geometry::Point& point : state) unpacker(point);
        path.push_back(state);
    }
    return path;
}

}  // namespace asv::tools
