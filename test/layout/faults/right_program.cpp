// says: nothing, because it compiles

int main() {}
