// A sphere about the centre that keeps its size, where rays are marched along.
float sphere_value(RayPlace place) { return place.r - frame.sphere_form.x; }
float sphere_room(RayPlace place) { return sphere_value(place); }
