#pragma once
#include <span>
#include <vector>
#include "asv/geometry/primitives.hpp"
namespace asv::geometry { class BoxIndex { std::vector<Box> b; public: explicit BoxIndex(std::span<const Box> x):b(x.begin(),x.end()){}
 template<class V> bool visit(const Box& q, V&& v) const { for(size_t i=0;i<b.size();++i){const Box&o=b[i]; if(o.low.x<=q.high.x&&o.high.x>=q.low.x&&o.low.y<=q.high.y&&o.high.y>=q.low.y) if(v(i)) return true;} return false;} }; }
