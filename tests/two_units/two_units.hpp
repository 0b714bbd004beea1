#pragma once

struct seen {
  const void* metres;
  const void* water_ice;
  double restitution;
};

seen seen_by_two();
