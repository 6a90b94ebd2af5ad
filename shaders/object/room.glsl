#define ROOM_PART 0.8   // of the room along a ray, a step to the next sample
